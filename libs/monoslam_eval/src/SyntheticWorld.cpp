// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/SyntheticWorld.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kTrueScore = 0.95;
constexpr double kClutterScore = 0.85;

Eigen::Vector2d normalPixel(std::mt19937& rng)
{
    std::normal_distribution<double> normal;
    const double u = normal(rng);
    return {u, normal(rng)};
}

/** Uniform in the region's ellipse. */
Eigen::Vector2d uniformIn(const SearchRegion& region, std::mt19937& rng)
{
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    Eigen::Vector2d d;
    do
    {
        d[0] = uniform(rng);
        d[1] = uniform(rng);
    } while (d.squaredNorm() > 1.0);
    const Eigen::Matrix2d L = region.S.llt().matrixL();
    return region.centre + std::sqrt(region.gate) * (L * d);
}

bool inside(const SearchRegion& region, const Eigen::Vector2d& z)
{
    const Eigen::Vector2d nu = z - region.centre;
    return nu.dot(region.S.llt().solve(nu)) < region.gate;
}
}  // namespace

SyntheticWorld::SyntheticWorld(const SyntheticWorldOptions& options, unsigned seed)
    : camera_(options.camera), options_(options), rng_(seed)
{
    if (!(options.sigma_px > 0.0 && options.clutterPerSearch >= 0.0))
        throw std::invalid_argument("SyntheticWorld: sigma_px must be > 0, clutter >= 0");
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

const Eigen::Vector3d& SyntheticWorld::position(LandmarkId id) const
{
    return points_.at(static_cast<std::size_t>(id));
}

std::optional<Eigen::Vector2d> SyntheticWorld::truePixel(const Vector13d& x_v, LandmarkId id) const
{
    const auto uv = projectPixel(camera_, x_v, LandmarkKind::Point, position(id));
    return uv && camera_.contains(*uv) ? uv : std::nullopt;
}

std::optional<Eigen::Vector2d> SyntheticWorld::measure(const Vector13d& x_v, LandmarkId id)
{
    auto uv = truePixel(x_v, id);
    if (uv) *uv += options_.sigma_px * normalPixel(rng_);
    return uv;
}

FrameView SyntheticWorld::view(const Vector13d& x_v, const VisibilityOptions& visibility)
{
    struct Sighting
    {
        std::optional<Eigen::Vector2d> z;
        unsigned clutterSeed = 0;
    };
    const auto sightings = std::make_shared<std::map<LandmarkId, Sighting>>();
    FrameView frame;
    frame.predict = [this, visibility](const Belief& belief)
    { return predictMeasurements(belief, camera_, visibility); };
    frame.linearize = [this, visibility](const Eigen::VectorXd& x, const LandmarkSlot& slot)
    { return linearizeLandmark(x, slot, camera_, visibility); };
    frame.imageArea_px2 = 1.0 * options_.camera.width_px * options_.camera.height_px;
    frame.search = [this, x_v, sightings](const SearchRegion& region)
    {
        auto [at, fresh] = sightings->try_emplace(region.id);
        if (fresh)
        {
            at->second.z = measure(x_v, region.id);
            if (std::uniform_real_distribution<double>()(rng_) >= options_.detectionProbability)
                at->second.z.reset();
            at->second.clutterSeed = rng_();
        }
        const Eigen::Matrix2d R =
            options_.sigma_px * options_.sigma_px * Eigen::Matrix2d::Identity();
        SearchResult result;
        if (at->second.z && inside(region, *at->second.z))
            result.candidates.push_back({*at->second.z, kTrueScore, R});
        std::mt19937 clutter(at->second.clutterSeed);
        int count = options_.clutterPerSearch > 0.0
                        ? std::poisson_distribution<int>(options_.clutterPerSearch)(clutter)
                        : 0;
        while (count-- > 0)
            result.candidates.push_back({uniformIn(region, clutter), kClutterScore, R});
        const auto most = static_cast<std::size_t>(std::max(1, region.maxCandidates));
        if (result.candidates.size() > most) result.candidates.resize(most);
        return result;
    };
    return frame;
}
}  // namespace monoslam
