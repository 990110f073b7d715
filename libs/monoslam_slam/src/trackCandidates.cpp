// SPDX-License-Identifier: BSD-3-Clause
// How landmarks enter the map delayed: candidates followed in the image until their parallax suffices.
#include <algorithm>
#include <cmath>
#include <optional>

#include "LandmarkFinder.h"
#include "MapKeeper.h"
#include "monoslam_models/rowPose.h"

namespace monoslam
{
namespace
{
constexpr double kDegree = 0.017453292519943295;
constexpr double kEpipolarSigmas = 3.0 * 1.5;
}  // namespace

bool MapKeeper::mayEnter(const TrackedCorner& corner) const
{
    const InitializationOptions& rule = options_.initialization;
    if (!corner.triangulation || corner.seen < rule.min_seen) return false;
    const Triangulation& t = *corner.triangulation;
    const double rho = t.y(inverse_depth::kRho);
    const double least = rule.angle_min_deg * kDegree;
    const auto oblique = [least](double angle) { return angle > least && angle < M_PI - least; };
    return rho > 0.0 && t.alpha_rad >= rule.alpha_min_deg * kDegree && t.baseline >= rule.b_min &&
           t.baseline * rho >= rule.b_min_relative && oblique(t.beta_rad) && oblique(t.gamma_rad) &&
           t.epipolarResidual_rad < kEpipolarSigmas / camera_.parameters().fx_px;
}

Mixture MapKeeper::promoteCandidates(Mixture mixture, const FrameContext& frame)
{
    const UndelayedPrior noise = priorNow(best(mixture));
    std::vector<TrackedCorner> waiting;
    for (TrackedCorner& known : corners_)
    {
        auto corner = trackCorner(std::move(known), best(mixture), camera_, *frame.image,
                                  frame.index, trackerOptions(options_.search));
        if (!corner) continue;
        if (!mayEnter(*corner))
        {
            waiting.push_back(std::move(*corner));
            continue;
        }
        Mixture grown = addTriangulatedTo(mixture, *corner, noise.sigma_px);
        const Belief& after = best(grown);
        const Eigen::Index rho = after.landmarks.back().offset + inverse_depth::kRho;
        if (std::sqrt(after.P(rho, rho)) >
            options_.initialization.max_relative_sigma * after.x(rho))
        {
            waiting.push_back(std::move(*corner));
            continue;
        }
        mixture = std::move(grown);
        LandmarkRecord record;
        record.born = corner->born;
        record.born.pose = corner->first.pose;
        record.bornFrame = corner->bornFrame;
        record.lastSeen = frame.index;
        enter(corner->id, record, mixture);
        ++added_;
    }
    corners_ = std::move(waiting);
    return mixture;
}

Mixture MapKeeper::addTriangulatedTo(Mixture mixture, const TrackedCorner& corner,
                                     double sigma_px) const
{
    const std::size_t heaviest = bestIndex(mixture);
    for (std::size_t b = 0; b < mixture.size(); ++b)
    {
        Belief& belief = mixture[b].belief;
        std::optional<Triangulation> own = corner.triangulation;
        if (b != heaviest)
        {
            const CloneSlot* clone =
                corner.first.clone >= 0 ? belief.findClone(corner.first.clone) : nullptr;
            const Vector7d first = clone ? belief.clonePose(*clone) : corner.first.pose;
            own = triangulate(camera_, {first, corner.first.uv_px}, {belief.pose(), corner.uv_px});
            if (!own || !(own->y(inverse_depth::kRho) > 0.0)) continue;  // not from its poses
        }
        belief = addTriangulated(std::move(belief), corner.id, *own, corner.first, sigma_px,
                                 options_.initialization.sigma_floor);
    }
    return mixture;
}

Mixture MapKeeper::clonePose(Mixture mixture, CloneId clone)
{
    const auto& clones = best(mixture).clones;
    if (static_cast<int>(clones.size()) >= options_.initialization.max_clones)
    {
        const CloneId oldest = clones.front().id;
        corners_.erase(std::remove_if(corners_.begin(), corners_.end(),
                                      [oldest](const TrackedCorner& corner)
                                      { return corner.first.clone == oldest; }),
                       corners_.end());
        mixture = dropUnusedClones(std::move(mixture));
    }
    for (auto& weighted : mixture) weighted.belief = addClone(std::move(weighted.belief), clone);
    return mixture;
}

Mixture MapKeeper::startCandidates(Mixture mixture, const std::vector<Eigen::Vector2d>& pixels,
                                   const FrameContext& frame)
{
    if (pixels.empty()) return mixture;
    const InitializationOptions& rule = options_.initialization;
    const CloneId clone = rule.clone ? nextClone_++ : -1;
    const UndelayedPrior prior = priorNow(best(mixture));
    if (rule.clone) mixture = clonePose(std::move(mixture), clone);
    for (const auto& uv : pixels)
    {
        const auto global = globalPixel(camera_, best(mixture).camera(), uv, prior.rho0);
        if (!global) continue;
        TrackedCorner corner;
        corner.id = nextId_++;
        corner.born = {frame.image, uv, best(mixture).pose(), {}};
        corner.first.clone = clone;
        corner.first.pose = best(mixture).pose();
        corner.first.variance = best(mixture).P.diagonal().head<7>();
        corner.first.uv_px = *global;
        corner.uv_px = uv;
        corner.rho = prior.rho0;
        corner.sigma_rho = prior.sigma_rho;
        corner.bornFrame = frame.index;
        corners_.push_back(corner);
    }
    return mixture;
}

Mixture MapKeeper::dropUnusedClones(Mixture mixture) const
{
    for (auto& weighted : mixture)
    {
        std::vector<CloneId> unused;
        for (const auto& slot : weighted.belief.clones)
            if (std::none_of(corners_.begin(), corners_.end(),
                             [&slot](const TrackedCorner& corner)
                             { return corner.first.clone == slot.id; }))
                unused.push_back(slot.id);
        weighted.belief = removeClones(std::move(weighted.belief), unused);
    }
    return mixture;
}
}  // namespace monoslam
