// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/simulate.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "monoslam_eval/SmoothPath.h"

namespace monoslam
{
namespace
{
constexpr double kBorder_px = 10.0;

/** Random numbers of one purpose, whatever is drawn for the others. */
enum class Stream : unsigned
{
    Target = 1,
    Landmarks,
    WrongMatches,
    Moving,
};

std::mt19937 streamOf(unsigned seed, Stream stream)
{
    std::seed_seq words{seed, static_cast<unsigned>(stream)};
    return std::mt19937(words);
}

template <int N>
Eigen::Matrix<double, N, 1> drawDirection(std::mt19937& rng)
{
    std::normal_distribution<double> normal;
    Eigen::Matrix<double, N, 1> d;
    for (double& number : d) number = normal(rng);
    return d.normalized();
}

/** A landmark that x_v sees, not the target's, and its pixel. */
struct Seen
{
    LandmarkId id = -1;
    Eigen::Vector2d uv_px;
};

class Builder
{
   public:
    Builder(const SimulationOptions& options, unsigned seed)
        : options_(options),
          seed_(seed),
          path_(options.amplitude_m, options.amplitude_rad, seed),
          world_(options.world, seed)
    {
    }

    Simulation build()
    {
        addTarget();
        addLandmarks();
        if (options_.wrongMatches.landmarks > 0) addWrongMatches();
        if (options_.moving.landmarks > 0) addMoving();
        result_.camera = options_.world.camera;
        for (LandmarkId id = 0; id < count_; ++id) result_.landmarks.push_back(world_.position(id));
        for (long frame = 0; frame < options_.frames; ++frame)
        {
            result_.path.push_back(cameraAt(frame));
            result_.frames.push_back(world_.observe(result_.path.back(), frame));
        }
        return std::move(result_);
    }

   private:
    [[nodiscard]] Vector13d cameraAt(double frame) const
    {
        return path_.at(options_.world.frame_s * frame);
    }

    void addTarget()
    {
        std::mt19937 rng = streamOf(seed_, Stream::Target);
        std::normal_distribution<double> normal(0.0, options_.target.sigma_m);
        for (Eigen::Vector3d p : options_.target.points())
        {
            for (double& coordinate : p) coordinate += normal(rng);
            count_ = world_.addLandmark(p) + 1;
        }
        target_ = count_;
    }

    void addLandmarks()
    {
        std::mt19937 rng = streamOf(seed_, Stream::Landmarks);
        std::uniform_real_distribution<double> frame(0.0, options_.frames);
        std::uniform_real_distribution<double> rho(1.0 / options_.farthest_m,
                                                   1.0 / options_.nearest_m);
        for (int i = 0; i < options_.landmarks; ++i)
            count_ = world_.addLandmarkInView(cameraAt(frame(rng)), rho(rng), kBorder_px) + 1;
    }

    [[nodiscard]] std::vector<Seen> seenAt(long frame, int least, const char* section) const
    {
        std::vector<Seen> seen;
        const Vector13d x_v = cameraAt(static_cast<double>(frame));
        for (LandmarkId id = target_; id < count_; ++id)
            if (const auto uv = world_.truePixel(x_v, id)) seen.push_back({id, *uv});
        if (seen.size() < static_cast<std::size_t>(least))
            throw std::invalid_argument(
                std::string("[") + section + "] landmarks = " + std::to_string(least) + ": only " +
                std::to_string(seen.size()) + " are in view in frame " + std::to_string(frame));
        return seen;
    }

    void addWrongMatches()
    {
        const WrongMatchesOptions& o = options_.wrongMatches;
        std::mt19937 rng = streamOf(seed_, Stream::WrongMatches);
        std::vector<Seen> seen = seenAt(o.first_frame, o.landmarks, "wrong_matches");
        const std::size_t middle =
            std::uniform_int_distribution<std::size_t>(0, seen.size() - 1)(rng);
        const Eigen::Vector2d centre = seen[middle].uv_px;
        std::sort(seen.begin(), seen.end(),
                  [&](const Seen& a, const Seen& b)
                  { return (a.uv_px - centre).squaredNorm() < (b.uv_px - centre).squaredNorm(); });
        WrongMatches group;
        for (int i = 0; i < o.landmarks; ++i)
            group.landmarks.push_back(seen[static_cast<std::size_t>(i)].id);
        group.firstFrame = o.first_frame;
        group.frames = o.frames;
        group.trueHidden = o.hide_true;
        if (o.kind == WrongMatchesOptions::Kind::Offset)
            group.offset_px = o.offset_px * drawDirection<2>(rng);
        else
            group.shift_m = o.shift_m * drawDirection<3>(rng);
        result_.wrongGroup = group.landmarks;
        world_.add(std::move(group));
    }

    void addMoving()
    {
        const MovingOptions& o = options_.moving;
        std::mt19937 rng = streamOf(seed_, Stream::Moving);
        std::vector<Seen> seen = seenAt(o.first_frame, o.landmarks, "moving");
        std::shuffle(seen.begin(), seen.end(), rng);
        const Eigen::Vector3d v_w = o.speed_mps * drawDirection<3>(rng);
        for (int i = 0; i < o.landmarks; ++i)
        {
            result_.moved.push_back(seen[static_cast<std::size_t>(i)].id);
            world_.add({result_.moved.back(), o.first_frame, v_w});
        }
    }

    const SimulationOptions& options_;
    unsigned seed_;
    SmoothPath path_;
    SyntheticWorld world_;
    LandmarkId count_ = 0;   ///< of the landmarks
    LandmarkId target_ = 0;  ///< of those that are the target's
    Simulation result_;
};
}  // namespace

Simulation simulate(const SimulationOptions& options, unsigned seed)
{
    return Builder(options, seed).build();
}
}  // namespace monoslam
