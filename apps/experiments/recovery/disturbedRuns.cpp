// SPDX-License-Identifier: BSD-3-Clause
#include "disturbedRuns.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "monoslam_eval/simulate.h"
#include "monoslam_support/ThreadClock.h"

namespace monoslam
{
namespace
{
constexpr double kTimes = 2.0;
constexpr double kNegligible_m = 0.001;
constexpr int kLeastGroup = 3, kLargestGroup = 10;

/** Position errors of all frames from the group's beginning [m], and the group's wrong pairs. */
struct Branch
{
    std::vector<double> errors_m;
    long wrongMatched = 0;
};

SimulationOptions optionsOf(const Disturbance& disturbance, int duration, unsigned seed)
{
    SimulationOptions o;
    o.frames = kGroupBegins + kDurations.back() + kFramesToRecover;
    o.landmarks = kLandmarks;
    o.wrongMatches.landmarks =
        kLeastGroup + static_cast<int>(seed % (kLargestGroup - kLeastGroup + 1));
    o.wrongMatches.first_frame = kGroupBegins;
    o.wrongMatches.frames = duration;
    o.wrongMatches.kind = disturbance.kind;
    o.wrongMatches.hide_true = disturbance.hide_true;
    return o;
}

/** Association is known where only true images are seen, one a landmark. */
Simulation withTruthOnly(Simulation world)
{
    for (PixelFrame& frame : world.frames)
        frame.features.erase(
            std::remove_if(frame.features.begin(), frame.features.end(),
                           [](const PixelFeature& feature) { return feature.truth < 0; }),
            frame.features.end());
    return world;
}

/** The pairs of the group's landmarks. */
std::vector<Association> pairsOf(const std::vector<LandmarkId>& group,
                                 const std::vector<Association>& all)
{
    std::vector<Association> pairs;
    std::copy_if(all.begin(), all.end(), std::back_inserter(pairs),
                 [&](const Association& pair)
                 { return std::count(group.begin(), group.end(), pair.id) > 0; });
    return pairs;
}

Branch follow(FeatureSlam slam, const Simulation& world, int frames)
{
    Branch branch;
    PairCounts counts;
    for (int i = kGroupBegins; i < kGroupBegins + frames; ++i)
    {
        const auto at = static_cast<std::size_t>(i);
        const FeatureReport report = slam.process(world.frames[at]);
        branch.errors_m.push_back((report.x_v - world.path[at]).head<3>().norm());
        counts.add(pairsOf(world.wrongGroup, report.associations), world.frames[at]);
    }
    branch.wrongMatched = counts.wrong;
    return branch;
}

/** Of the frames judged. */
double rms_m(const Branch& branch, int duration)
{
    double sum = 0.0;
    for (int i = duration + kFramesToRecover - kFramesJudged; i < duration + kFramesToRecover; ++i)
        sum += std::pow(branch.errors_m[static_cast<std::size_t>(i)], 2);
    return std::sqrt(sum / kFramesJudged);
}

Outcome judge(const Branch& branch, const Branch& reference, int duration)
{
    Outcome outcome;
    for (int i = 0; i < duration; ++i)
        outcome.worst_m = std::max(outcome.worst_m, branch.errors_m[static_cast<std::size_t>(i)]);
    outcome.after_m = rms_m(branch, duration);
    outcome.reference_m = rms_m(reference, duration);
    outcome.wrongMatched = branch.wrongMatched;
    return outcome;
}
}  // namespace

bool Outcome::recovered() const
{
    return after_m <= std::max(kTimes * reference_m, reference_m + kNegligible_m);
}

std::vector<Outcome> disturbedRuns(const Method& method, const Disturbance& disturbance,
                                   unsigned seed)
{
    const Simulation known = withTruthOnly(simulate(optionsOf(disturbance, 0, seed), seed));
    FeatureSlam slam({}, Camera(known.camera), Method{"known", "spatial_nn"}.make(), seed);
    for (std::size_t i = 0; i < kGroupBegins; ++i) static_cast<void>(slam.process(known.frames[i]));
    const Branch reference = follow(slam, known, kDurations.back() + kFramesToRecover);
    slam.use(method.make());
    std::vector<Outcome> outcomes;
    for (const int duration : kDurations)
    {
        const Simulation world = simulate(optionsOf(disturbance, duration, seed), seed);
        ThreadClock clock;
        const int frames = duration + kFramesToRecover;
        const Branch branch = follow(slam, world, frames);
        outcomes.push_back(judge(branch, reference, duration));
        outcomes.back().frame_ms = clock.lap_ms() / frames;
    }
    return outcomes;
}
}  // namespace monoslam
