// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <stdexcept>

#include "BatchSearch.h"
#include "ConditionalPrediction.h"
#include "monoslam_association/BatchAssociator.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_support/ThreadClock.h"
#include "relinearize.h"

namespace monoslam
{
namespace
{
/** Movement in the image, from where the projection was linearised to the posterior, below which
 *  its bend does not matter [px]: a turn by c pixels bends it by about c^2 / 1000. */
constexpr double kLinearEnough_px = 5.0;

/** Whether the update can factorise S, after the one inflation that it tries. */
bool updatable(const Prediction& prediction, std::vector<PixelMeasurement> pixels, double& d2)
{
    for (const double inflation : {1.0, 1.1})
    {
        for (PixelMeasurement& pixel : pixels) pixel.R *= inflation;
        const ConditionalPrediction accepted(prediction, pixels);
        if (!accepted.valid()) continue;
        d2 = accepted.d2();
        return true;
    }
    return false;
}

/** Fate, pixel, score and NIS of every pair that went into validation. */
void record(const AssociationProblem& problem, const std::vector<int>& chosen,
            std::vector<Association>& associations)
{
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
        const auto row = static_cast<std::size_t>(problem.rows[i]);
        const auto index = static_cast<std::size_t>(std::max(chosen[i], 0));
        const Candidate& candidate = problem.candidates[i][index];
        Association& association = associations[row];
        association.fate = chosen[i] < 0 ? Fate::Rejected : Fate::Matched;
        association.z = candidate.z;
        association.R = candidate.R;
        association.score = candidate.score;
        const PixelMeasurement pixel{problem.rows[i], candidate.z, candidate.R};
        association.nis = ConditionalPrediction(*problem.prediction, {pixel}).d2();
    }
}
}  // namespace

BatchAssociator::BatchAssociator(const BatchOptions& options)
    : options_(options),
      gate_(chi2Limit(2, options.gate_probability)),
      finalGate_(chi2Limit(2, options.final_gate_probability))
{
}

std::vector<int> BatchAssociator::decide(const AssociationProblem& problem,
                                         AssociationCounters& counters) const
{
    if (problem.rows.empty()) return {};
    std::vector<int> chosen = select(problem, counters);
    if (validatesJointly() && options_.final_gate_probability < 1.0)
        applyFinalGate(problem, finalGate_, chosen);
    return chosen;
}

std::vector<int> BatchAssociator::choose(BatchSearch& search, Belief& prior,
                                         const FrameView& view) const
{
    ThreadClock clock;
    AssociationCounters& counters = search.counters;
    search.searchFirstStage();
    counters.searchMs += clock.lap_ms();
    const std::vector<int> first = decide(search.problem(), counters);
    counters.selectMs += clock.lap_ms();
    const auto known = pixelsOf(search.problem(), first);
    std::vector<int> accepted = first;
    if (options_.max_iterations > 1 && known.size() >= kPoseFixingPairs)
    {
        search.linearizedAt = ekfUpdateMean(prior, search.prediction(), known);
        search.moveTo(predictAt(view, prior, search.linearizedAt));
        counters.updateMs += clock.lap_ms();
        accepted = decide(search.problem(), counters);
        counters.selectMs += clock.lap_ms();
    }
    search.searchRest(accepted);
    counters.searchMs += clock.lap_ms();

    const AssociationProblem& problem = search.problem();
    std::vector<int> chosen =
        problem.rows.size() == accepted.size() ? accepted : decide(problem, counters);
    const auto pixels = pixelsOf(problem, chosen);
    if (!pixels.empty() && !updatable(*problem.prediction, pixels, counters.jointD2))
    {
        ++counters.faults;
        chosen.assign(chosen.size(), -1);
    }
    record(problem, chosen, search.associations);
    counters.selectMs += clock.lap_ms();
    return chosen;
}

Belief BatchAssociator::update(Belief& prior, BatchSearch& search,
                               const std::vector<PixelMeasurement>& pixels,
                               const FrameView& view) const
{
    int faults = 0;
    Belief posterior = view.engine.update(prior, search.prediction(), pixels, &faults);
    Eigen::VectorXd linearizedAt = search.linearizedAt.size() > 0 ? search.linearizedAt : prior.x;
    for (int iteration = 2; iteration < options_.max_iterations; ++iteration)
    {
        const Eigen::VectorXd step = posterior.x - linearizedAt;
        if (largestShift_px(search.prediction(), pixels, step) < kLinearEnough_px) break;
        const Prediction again = predictAt(view, prior, posterior.x);
        const auto moved = onRowsOf(again, search.prediction(), pixels);
        if (moved.size() < pixels.size()) break;  // a landmark left the image: keep what we have
        linearizedAt = posterior.x;
        posterior = view.engine.update(prior, again, moved, &faults);
    }
    search.counters.faults += faults;
    return posterior;
}

Correction BatchAssociator::correct(Mixture predicted, const FrameView& view,
                                    std::mt19937& /*rng*/) const
{
    if (predicted.size() != 1)
        throw std::logic_error("BatchAssociator: the mixture must hold exactly one belief");
    Belief& belief = predicted.front().belief;
    ThreadClock clock;
    BatchSearch search(view.predict(belief), view, {gate_, maxCandidates(), options_});
    const double predictMs = clock.lap_ms();

    const std::vector<int> chosen = choose(search, belief, view);
    const std::vector<PixelMeasurement> pixels = pixelsOf(search.problem(), chosen);
    AssociationCounters& counters = search.counters;
    counters.updateMs += predictMs;
    counters.pairs = static_cast<long>(search.problem().rows.size());
    counters.rejected = counters.pairs - static_cast<long>(pixels.size());
    if (!pixels.empty())
    {
        ThreadClock updateClock;
        belief = update(belief, search, pixels, view);
        counters.updateMs += updateClock.lap_ms();
    }
    return {std::move(predicted), std::move(search.associations), counters};
}
}  // namespace monoslam
