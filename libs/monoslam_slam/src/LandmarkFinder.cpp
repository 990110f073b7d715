// SPDX-License-Identifier: BSD-3-Clause
#include "LandmarkFinder.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace monoslam
{
namespace
{
constexpr double kLeastRho = 1e-4;
constexpr double kDegree = 0.017453292519943295;

/** S with its axes cut so that the ellipse of the gate reaches at most radius_px. */
Eigen::Matrix2d clip(const Eigen::Matrix2d& S, double gate, double radius_px)
{
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(S);
    const double largest = radius_px * radius_px / gate;
    if (solver.eigenvalues()(1) <= largest) return S;
    const Eigen::Vector2d cut = solver.eigenvalues().cwiseMin(largest);
    return solver.eigenvectors() * cut.asDiagonal() * solver.eigenvectors().transpose();
}
}  // namespace

Eigen::Vector3d landmarkPoint(LandmarkKind kind, const Eigen::Ref<const Eigen::VectorXd>& y)
{
    if (kind == LandmarkKind::Point) return y.head<3>();
    Vector6d inFront = y.head<6>();
    inFront(inverse_depth::kRho) = std::max(inFront(inverse_depth::kRho), kLeastRho);
    return toPoint(inFront);
}

Eigen::Vector3d landmarkPoint(const Belief& belief, const LandmarkSlot& slot)
{
    return landmarkPoint(slot.kind, belief.x.segment(slot.offset, slot.size()));
}

CornerTrackerOptions trackerOptions(const SearchOptions& search)
{
    CornerTrackerOptions o;
    o.minScore = search.min_zncc;
    o.half_px = search.patch_px / 2;
    o.warp.maxScale = search.max_scale;
    o.warp.maxViewAngle_rad = search.max_view_angle_deg * kDegree;
    o.align.sigmaFloor_px = search.sigma_floor_px;
    o.align.noiseCorrelation =
        std::max(1.0, 4.0 * M_PI * search.smoothing_px * search.smoothing_px);
    return o;
}

LandmarkFinder::Expected& LandmarkFinder::expectedOf(LandmarkId id)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    return landmarks_[id];
}

const std::optional<Patch>& LandmarkFinder::patchOf(Expected& landmark, LandmarkId id) const
{
    const std::lock_guard<std::mutex> lock(landmark.mutex);
    std::optional<Patch>& patch = landmark.patch;
    if (std::exchange(landmark.sampled, true)) return patch;
    const auto record = records_.find(id);
    const Eigen::Index index = expected_.find(id);
    if (record == records_.end() || index < 0) return patch;
    const LandmarkSlot& slot = expected_.landmarks[static_cast<std::size_t>(index)];
    const CornerTrackerOptions tracker = trackerOptions(options_);
    const auto warp = predictWarp(camera_, record->second.born, expected_.pose(),
                                  landmarkPoint(expected_, slot), tracker.warp);
    if (warp) patch = samplePatch(record->second.born, *warp, tracker.half_px);
    return patch;
}

/** The peak aligned to sub-pixels: the same for every belief that comes upon it. */
std::optional<AlignedPatch> LandmarkFinder::align(Expected& landmark, LandmarkId id,
                                                  const Eigen::Vector2d& peak) const
{
    const std::lock_guard<std::mutex> lock(landmark.mutex);
    const std::pair<int, int> pixel(static_cast<int>(peak.x()), static_cast<int>(peak.y()));
    const auto [at, fresh] = landmark.aligned.try_emplace(pixel);
    if (!fresh) return at->second;
    AlignOptions options = trackerOptions(options_).align;
    options.sigmaFloor_px =
        std::max(options.sigmaFloor_px, std::sqrt(records_.at(id).variance_px2));
    at->second = alignPatch(image_, *landmark.patch, peak, options);
    return at->second;
}

std::optional<SlopeEstimate> LandmarkFinder::slopeSeen(LandmarkId id,
                                                       const Eigen::Vector2d& z) const
{
    const auto landmark = landmarks_.find(id);
    if (landmark == landmarks_.end()) return std::nullopt;
    for (const auto& [peak, aligned] : landmark->second.aligned)
        if (aligned && aligned->uv_px == z) return aligned->slope;
    return std::nullopt;
}

SearchResult LandmarkFinder::search(const SearchRegion& region)
{
    SearchResult result;
    Expected& landmark = expectedOf(region.id);
    const std::optional<Patch>& patch = patchOf(landmark, region.id);
    if (!patch)
    {
        result.status = SearchStatus::Unpredictable;
        return result;
    }
    PatchSearchRegion ellipse;
    ellipse.centre_px = region.centre;
    ellipse.gate = region.gate;
    ellipse.S = clip(region.S, region.gate, options_.max_radius_px);
    ellipse.minScore = region.minScore.value_or(options_.min_zncc);
    ellipse.maxPeaks = region.maxCandidates;
    const PatchSearch found = searchPatch(image_, *patch, ellipse);
    result.pixels = found.pixels;
    for (const auto& peak : found.peaks)
    {
        Candidate candidate{peak.uv_px, peak.score,
                            options_.sigma_px * options_.sigma_px * Eigen::Matrix2d::Identity()};
        if (options_.subpixel)
        {
            const auto aligned = align(landmark, region.id, peak.uv_px);
            if (!aligned) continue;
            candidate.z = aligned->uv_px;
            candidate.R = aligned->R;
        }
        result.candidates.push_back(candidate);
    }
    return result;
}
}  // namespace monoslam
