// SPDX-License-Identifier: BSD-3-Clause
// How many landmarks enter the map, and those that do so undelayed.
#include <algorithm>

#include "MapKeeper.h"

namespace monoslam
{
namespace
{
constexpr int kAllCells = 1 << 20;
constexpr double kWorthDetecting = 0.1;  // of the target: fewer missing landmarks can wait
}  // namespace

Mixture MapKeeper::addUndelayedAt(Mixture mixture, const std::vector<Eigen::Vector2d>& pixels,
                                  const UndelayedPrior& prior, const FrameContext& frame)
{
    std::vector<NewLandmark> corners;
    for (const auto& uv : pixels)
        if (camera_.unproject(uv)) corners.push_back({nextId_++, uv});
    for (auto& weighted : mixture)
        weighted.belief = addUndelayed(std::move(weighted.belief), camera_, corners, prior);
    for (const NewLandmark& corner : corners)
    {
        LandmarkRecord record;
        record.born = {frame.image, corner.uv_px, best(mixture).pose(), {}};
        record.bornFrame = record.lastSeen = frame.index;
        enter(corner.id, record, mixture);
        ++added_;
    }
    return mixture;
}

Mixture MapKeeper::addFirst(Mixture mixture, const FrameContext& frame, double rho0,
                            double sigma_rho)
{
    UndelayedPrior prior = priorNow(best(mixture));
    prior.rho0 = rho0;
    prior.sigma_rho = sigma_rho;
    DetectionOptions detection = options_.detection;
    detection.maxCells = kAllCells;
    const auto corners = detectCorners(*frame.image, takenPixels(best(mixture)),
                                       options_.map.measured_target, detection, strongest_, rng_);
    std::vector<Eigen::Vector2d> pixels;
    for (const Corner& corner : corners) pixels.push_back(corner.uv_px);
    return addUndelayedAt(std::move(mixture), pixels, prior, frame);
}

Belief MapKeeper::addAgain(Belief belief, const std::vector<Association>& associations,
                           const std::vector<LandmarkId>& distrusted) const
{
    std::vector<NewLandmark> again;
    for (const Association& association : associations)
    {
        const LandmarkId id = association.id;
        if (association.fate != Fate::Matched || records_.count(id) == 0) continue;
        if (belief.find(id) >= 0) continue;
        if (std::find(distrusted.begin(), distrusted.end(), id) == distrusted.end())
            again.push_back({id, association.z});
    }
    const UndelayedPrior prior = priorNow(belief);
    return addUndelayed(std::move(belief), camera_, again, prior);
}

Mixture MapKeeper::addNew(Mixture mixture, const FrameContext& frame)
{
    const InitializationOptions& rule = options_.initialization;
    const bool undelayed = starting_ || rule.method == InitializationMethod::Undelayed;
    const int have = matchedNow_ + added_ + (undelayed ? 0 : candidates());
    const int wanted =
        std::min(options_.map.measured_target - have,
                 undelayed ? options_.map.measured_target : rule.max_candidates - candidates());
    int urgent = undelayed ? wanted : 0;
    if (!undelayed && rule.method == InitializationMethod::Hybrid)
        urgent = std::max(0, rule.hybrid_min_measured - matchedNow_ - added_);
    if (std::max(wanted, urgent) < kWorthDetecting * options_.map.measured_target) return mixture;

    DetectionOptions detection = options_.detection;
    if (matchedNow_ < rule.hybrid_min_measured)  // starving: time does not matter now
        detection.maxCells = kAllCells;
    const auto corners = detectCorners(*frame.image, takenPixels(best(mixture)),
                                       std::max(wanted, urgent), detection, strongest_, rng_);
    const UndelayedPrior prior = priorNow(best(mixture));
    std::vector<Eigen::Vector2d> now;
    std::vector<Eigen::Vector2d> delayed;
    for (const Corner& corner : corners) (urgent-- > 0 ? now : delayed).push_back(corner.uv_px);
    mixture = addUndelayedAt(std::move(mixture), now, prior, frame);
    return startCandidates(std::move(mixture), delayed, frame);
}
}  // namespace monoslam
