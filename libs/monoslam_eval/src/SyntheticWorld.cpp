// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/SyntheticWorld.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kTicksPerSecond = 1e7;

Eigen::Vector2d normalPixel(std::mt19937& rng)
{
    std::normal_distribution<double> normal;
    const double u = normal(rng);
    return {u, normal(rng)};
}

double uniform(std::mt19937& rng, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(rng);
}

/** A stream of its own for every landmark of every frame. */
std::mt19937 streamOf(unsigned seed, long frame, LandmarkId id)
{
    std::seed_seq words{seed, static_cast<unsigned>(frame), static_cast<unsigned>(id)};
    return std::mt19937(words);
}
}  // namespace

SyntheticWorld::SyntheticWorld(const SyntheticWorldOptions& options, unsigned seed)
    : camera_(options.camera), options_(options), seed_(seed), rng_(seed)
{
    const auto inside = [](double p, double low, double high) { return p >= low && p <= high; };
    if (!(options.sigma_px > 0.0 && options.frame_s > 0.0 && options.scoreDecay > 0.0 &&
          options.clutterPerImage >= 0.0 && inside(options.detectionProbability, 0.0, 1.0) &&
          inside(options.minScore, -1.0, 1.0)))
        throw std::invalid_argument(
            "SyntheticWorld: sigma_px, frame_s and scoreDecay must be > 0, clutter >= 0, "
            "probabilities in [0, 1], minScore in [-1, 1]");
}

LandmarkId SyntheticWorld::addLandmark(const Eigen::Vector3d& p_w)
{
    points_.push_back(p_w);
    return static_cast<LandmarkId>(points_.size()) - 1;
}

LandmarkId SyntheticWorld::addLandmarkInView(const Vector13d& x_v, double rho, double border_px)
{
    const CameraParameters& c = options_.camera;
    std::uniform_real_distribution<double> u(border_px, c.width_px - 1.0 - border_px);
    std::uniform_real_distribution<double> v(border_px, c.height_px - 1.0 - border_px);
    const double u_px = u(rng_);
    const auto ray = camera_.unproject({u_px, v(rng_)});
    if (!ray || !(rho > 0.0))
        throw std::invalid_argument("addLandmarkInView: rho <= 0 or a pixel beyond the lens model");
    const Eigen::Vector4d q_wc = x_v.segment<4>(camera_state::kOrientation);
    return addLandmark(x_v.head<3>() + rotate(q_wc, ray->normalized()) / rho);
}

void SyntheticWorld::add(WrongMatches group)
{
    for (const LandmarkId id : group.landmarks) static_cast<void>(position(id));
    groups_.push_back(std::move(group));
}

void SyntheticWorld::add(const LandmarkMotion& motion)
{
    static_cast<void>(position(motion.landmark));
    motions_.push_back(motion);
}

const Eigen::Vector3d& SyntheticWorld::position(LandmarkId id) const
{
    return points_.at(static_cast<std::size_t>(id));
}

Eigen::Vector3d SyntheticWorld::position(LandmarkId id, long frame) const
{
    Eigen::Vector3d p = position(id);
    for (const LandmarkMotion& motion : motions_)
        if (motion.landmark == id && frame > motion.firstFrame)
            p += options_.frame_s * static_cast<double>(frame - motion.firstFrame) * motion.v_w;
    return p;
}

bool SyntheticWorld::hasMoved(LandmarkId id, long frame) const
{
    return position(id, frame) != position(id);
}

const WrongMatches* SyntheticWorld::groupOf(LandmarkId id, long frame) const
{
    for (const WrongMatches& group : groups_)
        if (frame >= group.firstFrame && frame < group.firstFrame + group.frames &&
            std::count(group.landmarks.begin(), group.landmarks.end(), id) > 0)
            return &group;
    return nullptr;
}

std::optional<Eigen::Vector2d> SyntheticWorld::project(const Vector13d& x_v,
                                                       const Eigen::Vector3d& p_w) const
{
    const auto uv = projectPixel(camera_, x_v, LandmarkKind::Point, p_w);
    return uv && camera_.contains(*uv) ? uv : std::nullopt;
}

std::optional<Eigen::Vector2d> SyntheticWorld::truePixel(const Vector13d& x_v, LandmarkId id) const
{
    return project(x_v, position(id));
}

std::optional<Eigen::Vector2d> SyntheticWorld::measure(const Vector13d& x_v, LandmarkId id)
{
    auto uv = truePixel(x_v, id);
    if (uv) *uv += options_.sigma_px * normalPixel(rng_);
    return uv;
}

PixelFeature SyntheticWorld::feature(LandmarkId id, const Eigen::Vector2d& z, double score,
                                     LandmarkId truth) const
{
    PixelFeature feature;
    feature.z = z;
    feature.R *= options_.sigma_px * options_.sigma_px;
    feature.resembles = {{id, score}};
    feature.truth = truth;
    return feature;
}

/** From the distribution function of the exponential that is cut off at minScore. */
double SyntheticWorld::drawTrueScore(std::mt19937& rng) const
{
    const double decay = options_.scoreDecay;
    const double tail = -std::expm1(-decay * (1.0 - options_.minScore));
    return 1.0 + std::log1p(-tail * uniform(rng, 0.0, 1.0)) / decay;
}

void SyntheticWorld::addImages(const Moment& now, LandmarkId id, std::mt19937& rng,
                               PixelFrame& frame) const
{
    // All is drawn in any case, so that the same numbers come after it.
    const bool detected = uniform(rng, 0.0, 1.0) < options_.detectionProbability;
    const Eigen::Vector2d noise = options_.sigma_px * normalPixel(rng);
    const Eigen::Vector2d wrongNoise = options_.sigma_px * normalPixel(rng);
    const double score = drawTrueScore(rng), wrongScore = drawTrueScore(rng);
    if (!detected) return;
    const Eigen::Vector3d p_w = position(id, now.frame);
    const WrongMatches* group = groupOf(id, now.frame);
    if (const auto uv = project(now.x_v, p_w); uv && (group == nullptr || !group->trueHidden))
        frame.features.push_back(
            feature(id, *uv + noise, score, hasMoved(id, now.frame) ? kOfNoLandmark : id));
    if (group == nullptr) return;
    if (const auto uv = project(now.x_v, p_w + group->shift_m))
        frame.features.push_back(
            feature(id, *uv + group->offset_px + wrongNoise, wrongScore, kOfNoLandmark));
}

void SyntheticWorld::addClutter(LandmarkId id, std::mt19937& rng, PixelFrame& frame) const
{
    if (options_.clutterPerImage <= 0.0) return;
    int count = std::poisson_distribution<int>(options_.clutterPerImage)(rng);
    while (count-- > 0)
    {
        const double u_px = uniform(rng, 0.0, options_.camera.width_px - 1.0);
        const double v_px = uniform(rng, 0.0, options_.camera.height_px - 1.0);
        const double score = uniform(rng, options_.minScore, 1.0);
        frame.features.push_back(feature(id, {u_px, v_px}, score, kOfNoLandmark));
    }
}

PixelFrame SyntheticWorld::observe(const Vector13d& x_v, long frame) const
{
    PixelFrame seen;
    seen.t_s = std::round(options_.frame_s * static_cast<double>(frame) * kTicksPerSecond) /
               kTicksPerSecond;
    for (LandmarkId id = 0; id < static_cast<LandmarkId>(points_.size()); ++id)
    {
        std::mt19937 rng = streamOf(seed_, frame, id);
        addImages({x_v, frame}, id, rng, seen);
        addClutter(id, rng, seen);
    }
    std::stable_sort(seen.features.begin(), seen.features.end(),
                     [](const PixelFeature& a, const PixelFeature& b)
                     { return a.z.y() < b.z.y(); });
    std::int64_t number = 0;
    for (PixelFeature& feature : seen.features) feature.id = number++;
    return seen;
}
}  // namespace monoslam
