// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/CornerTracker.h"

#include <algorithm>
#include <cmath>

#include "monoslam_models/quaternion.h"
#include "monoslam_models/rowPose.h"
#include "monoslam_vision/searchPatch.h"

namespace monoslam
{
namespace
{
constexpr double kRivalDistance_px = 5.0;
constexpr double kTriangulationTrust_rad = 0.0175;  // 1 degree: from here the depth is measured
constexpr int kMinFramesForRatio = 6;

/** The two ends of the stretch of ray that may hold the point, and its middle, in pixels now. */
struct Band
{
    Eigen::Vector2d far_px;
    Eigen::Vector2d near_px;
    Eigen::Vector2d middle_px;
    Eigen::Vector3d middle_w;
};

std::optional<Band> projectBand(const TrackedCorner& corner, const Belief& belief,
                                const Camera& camera)
{
    const auto born =
        initializeUndelayed(camera, corner.first.pose, corner.first.uv_px, corner.rho);
    if (!born) return std::nullopt;
    const auto at = [&](double rho)
    {
        Vector6d y = born->y;
        y(inverse_depth::kRho) = rho;
        return projectPixel(camera, belief.camera(), LandmarkKind::InverseDepth, y);
    };
    const auto far = at(std::max(corner.rho - 2.0 * corner.sigma_rho, 0.0));
    const auto near = at(corner.rho + 2.0 * corner.sigma_rho);
    const auto middle = at(corner.rho);
    if (!far || !near || !middle) return std::nullopt;
    return Band{*far, *near, *middle, toPoint(born->y)};
}

/** An ellipse that covers the band: along it up to maxReach, across it the least half width. */
PatchSearchRegion regionOf(const Band& band, const CornerTrackerOptions& options)
{
    const Eigen::Vector2d along = band.near_px - band.far_px;
    const double length = along.norm();
    const Eigen::Vector2d unit =
        length > 1e-6 ? Eigen::Vector2d(along / length) : Eigen::Vector2d::UnitX();
    const Eigen::Vector2d across(-unit.y(), unit.x());
    const double width = options.minHalfWidth_px;
    const double reach = std::clamp(0.5 * length + width, width, options.maxReach_px);
    PatchSearchRegion region;
    region.centre_px = length < 2.0 * options.maxReach_px
                           ? Eigen::Vector2d(0.5 * (band.near_px + band.far_px))
                           : band.middle_px;
    region.S =
        reach * reach * unit * unit.transpose() + width * width * across * across.transpose();
    region.gate = 1.0;
    region.minScore = options.minScore;
    region.maxPeaks = 2;
    region.peakDistance_px = kRivalDistance_px;
    return region;
}

std::optional<AlignedPatch> find(const TrackedCorner& corner, const Band& band,
                                 const Belief& belief, const Camera& camera,
                                 const PreparedImage& image, const CornerTrackerOptions& options)
{
    const auto warp = predictWarp(camera, corner.born, belief.pose(), band.middle_w, options.warp);
    if (!warp) return std::nullopt;
    const auto patch = samplePatch(corner.born, *warp, options.half_px);
    if (!patch) return std::nullopt;
    const PatchSearch search = searchPatch(image, *patch, regionOf(band, options));
    if (search.peaks.empty()) return std::nullopt;
    if (search.peaks.size() > 1 &&
        search.peaks[0].score - search.peaks[1].score < options.uniqueness)
        return std::nullopt;
    return alignPatch(image, *patch, search.peaks.front().uv_px, options.align);
}

/** Depth from the pair of views, once the parallax says something about it. */
void refineDepth(TrackedCorner& corner, const Belief& belief, const Camera& camera)
{
    const auto global = globalPixel(camera, belief.camera(), corner.uv_px, corner.rho);
    if (!global) return;
    corner.triangulation =
        triangulate(camera, {corner.first.pose, corner.first.uv_px}, {belief.pose(), *global});
    if (!corner.triangulation || corner.triangulation->alpha_rad < kTriangulationTrust_rad) return;
    const Eigen::Vector3d p_w = toPoint(corner.triangulation->y);
    const double distance = (p_w - corner.first.pose.head<3>()).norm();
    if (!(distance > 1e-6)) return;
    corner.rho = 1.0 / distance;
    const double sigmaAngle = 1.0 / camera.parameters().fx_px;
    corner.sigma_rho =
        std::min(corner.sigma_rho,
                 2.0 * corner.rho * sigmaAngle / std::sin(corner.triangulation->alpha_rad) +
                     0.02 * corner.rho);
}
}  // namespace

std::optional<TrackedCorner> trackCorner(TrackedCorner corner, const Belief& belief,
                                         const Camera& camera, const PreparedImage& image,
                                         long frame, const CornerTrackerOptions& options)
{
    if (corner.first.clone >= 0)
    {
        const CloneSlot* clone = belief.findClone(corner.first.clone);
        if (!clone) return std::nullopt;
        corner.first.pose = belief.clonePose(*clone);
    }
    corner.triangulation.reset();
    if (frame - corner.bornFrame > options.maxAge_frames) return std::nullopt;
    const auto band = projectBand(corner, belief, camera);
    if (!band || !camera.contains(band->middle_px, options.half_px + 2.0)) return std::nullopt;
    const auto found = find(corner, *band, belief, camera, image, options);
    if (!found)
    {
        ++corner.missed;
        ++corner.missedInRow;
        const int frames = corner.seen + corner.missed;
        if (corner.missedInRow > options.maxMissedInRow ||
            (frames > kMinFramesForRatio && 2 * corner.seen < frames))
            return std::nullopt;
        return corner;
    }
    corner.uv_px = found->uv_px;
    corner.born.slope.learn(found->slope);
    ++corner.seen;
    corner.missedInRow = 0;
    refineDepth(corner, belief, camera);
    return corner;
}
}  // namespace monoslam
