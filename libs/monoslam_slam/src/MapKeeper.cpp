// SPDX-License-Identifier: BSD-3-Clause
#include "MapKeeper.h"

#include <algorithm>
#include <cmath>

#include "LandmarkFinder.h"
#include "monoslam_filter/linearLandmarks.h"
#include "postFitResiduals.h"

namespace monoslam
{
namespace
{
constexpr double kLeastRho = 1e-3;
constexpr double kForget = 0.1;   ///< weight of one match in a landmark's own noise
constexpr double kPostFit = 2.0;  ///< a residual is less than the error: the landmark follows it

double sigmaRho(const Belief& belief, const LandmarkSlot& slot)
{
    const Eigen::Index rho = slot.offset + inverse_depth::kRho;
    return std::sqrt(std::max(belief.P(rho, rho), 0.0));
}
}  // namespace

MapKeeper::MapKeeper(const MonoSlamOptions& options, const Camera& camera, unsigned seed)
    : options_(options), camera_(camera), rng_(seed)
{
}

Mixture MapKeeper::revise(Mixture mixture, const Correction& correction, const FrameContext& frame)
{
    added_ = 0;
    removed_ = 0;
    noteFates(mixture, correction, frame.index);
    mixture = removeBad(std::move(mixture), frame.index);
    mixture = convert(std::move(mixture));
    mixture = promoteCandidates(std::move(mixture), frame);
    mixture = addNew(std::move(mixture), frame);
    mixture = boundState(std::move(mixture));
    return dropUnusedClones(std::move(mixture));
}

void MapKeeper::noteResiduals(const Belief& belief, const std::vector<Association>& associations)
{
    for (const Association& association : associations)
    {
        const auto record = records_.find(association.id);
        if (association.fate != Fate::Matched || record == records_.end()) continue;
        const auto square = squaredResidual(belief, camera_, association);
        if (!square) continue;
        double& variance = record->second.variance_px2;
        variance += kForget * (kPostFit * 0.5 * *square - variance);
    }
}

void MapKeeper::learnSlopes(const std::vector<Association>& associations,
                            const LandmarkFinder& finder)
{
    for (const Association& association : associations)
    {
        const auto record = records_.find(association.id);
        if (association.fate != Fate::Matched || record == records_.end()) continue;
        if (const auto slope = finder.slopeSeen(association.id, association.z))
            record->second.born.slope.learn(*slope);
    }
}

bool MapKeeper::isBad(const TrackRecord& record, long frame) const
{
    const MapOptions& map = options_.map;
    const auto recent = std::count_if(record.strikes.begin(), record.strikes.end(),
                                      [&](long at) { return frame - at < map.strike_frames; });
    if (map.delete_on_reject && recent > 0 && record.strikes.back() == frame) return true;
    if (!starting_ && recent >= map.strikes) return true;
    return record.searched > (starting_ ? 3 : 1) * map.min_searched &&
           record.matched < map.min_found_ratio * record.searched;
}

/** Landmarks that a belief is to give up; an implausible rho that can be mended is. */
std::vector<LandmarkId> MapKeeper::badOnes(Belief& belief, const TrackRecords& tracks,
                                           long frame) const
{
    std::vector<LandmarkId> gone;
    for (const auto& [id, track] : tracks)
        if (isBad(track, frame)) gone.push_back(id);
    for (const auto& slot : belief.landmarks)
    {
        if (slot.kind != LandmarkKind::InverseDepth) continue;
        double& rho = belief.x(slot.offset + inverse_depth::kRho);
        if (rho > 0.0) continue;
        // A negative rho puts the point behind its anchor: push it to almost infinity if that is
        // plausible, else give it up.
        if (rho + 2.0 * sigmaRho(belief, slot) > 0.0)
            rho = kLeastRho;
        else
            gone.push_back(slot.id);
    }
    return gone;
}

Mixture MapKeeper::removeBad(Mixture mixture, long frame)
{
    for (std::size_t b = 0; b < mixture.size(); ++b)
        remove(mixture, b, badOnes(mixture[b].belief, tracks_[b], frame));
    return mixture;
}

std::vector<LandmarkId> MapKeeper::leastUseful(const TrackRecords& tracks, std::size_t count) const
{
    std::vector<LandmarkId> order;
    for (const auto& entry : tracks)
        if (!records_.at(entry.first).known) order.push_back(entry.first);
    std::stable_sort(order.begin(), order.end(),
                     [&tracks](LandmarkId a, LandmarkId b)
                     {
                         const TrackRecord& first = tracks.at(a);
                         const TrackRecord& second = tracks.at(b);
                         if (first.lastSeen != second.lastSeen)
                             return first.lastSeen < second.lastSeen;
                         return first.matched < second.matched;
                     });
    order.resize(std::min(order.size(), count));
    return order;
}

Mixture MapKeeper::boundState(Mixture mixture)
{
    const auto most = static_cast<std::size_t>(options_.map.max_landmarks);
    for (std::size_t b = 0; b < mixture.size(); ++b)
        if (tracks_[b].size() > most)
            remove(mixture, b, leastUseful(tracks_[b], tracks_[b].size() - most));
    return mixture;
}

Mixture MapKeeper::convert(Mixture mixture) const
{
    if (options_.map.convert_linearity <= 0.0) return mixture;
    for (auto& weighted : mixture)
    {
        const auto ready = linearLandmarks(weighted.belief, options_.map.convert_linearity);
        weighted.belief = convertToPoints(std::move(weighted.belief), ready);
    }
    return mixture;
}

std::vector<Eigen::Vector2d> MapKeeper::takenPixels(const Belief& belief) const
{
    std::vector<Eigen::Vector2d> taken;
    for (const auto& slot : belief.landmarks)
    {
        const auto pixel = projectPixel(camera_, belief.camera(), slot.kind,
                                        belief.x.segment(slot.offset, slot.size()));
        if (pixel && camera_.contains(*pixel)) taken.push_back(*pixel);
    }
    for (const auto& corner : corners_) taken.push_back(corner.uv_px);
    return taken;
}

UndelayedPrior MapKeeper::priorNow(const Belief& belief) const
{
    std::vector<double> rho;
    for (const auto& slot : belief.landmarks)
    {
        const auto record = records_.find(slot.id);
        if (record == records_.end() || record->second.matched < options_.initialization.min_seen)
            continue;
        const double distance = (landmarkPoint(belief, slot) - belief.x.head<3>()).norm();
        if (distance > 0.0) rho.push_back(1.0 / distance);
    }
    UndelayedPrior prior;
    prior.rho0 = options_.initialization.rho0;
    prior.sigma_px =
        options_.search.subpixel ? options_.search.sigma_floor_px * 2.0 : options_.search.sigma_px;
    if (!rho.empty())
    {
        const auto middle = rho.begin() + static_cast<std::ptrdiff_t>(rho.size() / 2);
        std::nth_element(rho.begin(), middle, rho.end());
        prior.rho0 = *middle;
    }
    prior.sigma_rho = options_.initialization.relative_sigma_rho * prior.rho0;
    return prior;
}
}  // namespace monoslam
