// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/BatchAssociator.h"

#include <algorithm>
#include <stdexcept>

#include "BatchSearch.h"
#include "iteratedUpdate.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_support/ThreadClock.h"

namespace monoslam
{
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

int BatchAssociator::firstStageCandidates() const
{
    return choosesAmongSeveral() ? std::max(maxCandidates(), options_.first_stage_candidates)
                                 : maxCandidates();
}

bool BatchAssociator::getsSeveralCandidates() const
{
    return maxCandidates() > 1 || (options_.first_stage > 0 && firstStageCandidates() > 1);
}

std::vector<int> BatchAssociator::choose(BatchSearch& search, Belief& prior,
                                         const FrameView& view) const
{
    std::vector<int> chosen = searchInStages(
        search, prior, view, [this](BatchSearch& s) { return decide(s.problem(), s.counters); });
    ThreadClock clock;
    const AssociationProblem& problem = search.problem();
    const auto pixels = pixelsOf(problem, chosen);
    if (!pixels.empty() && !updatable(*problem.prediction, pixels, search.counters.jointD2))
    {
        ++search.counters.faults;
        chosen.assign(chosen.size(), -1);
    }
    recordPairs(problem, chosen, search.associations);
    search.counters.selectMs += clock.lap_ms();
    return chosen;
}

Correction BatchAssociator::correct(Mixture predicted, const FrameView& view,
                                    std::mt19937& /*rng*/) const
{
    Belief& belief = onlyBelief(predicted);
    ThreadClock clock;
    BatchSearch search(view.predict(belief), view,
                       {gate_, maxCandidates(), firstStageCandidates(), options_, minScore()});
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
        int faults = 0;
        belief = iteratedUpdate({belief, search.prediction(), search.linearizedAt}, pixels, view,
                                options_.max_iterations, faults);
        counters.faults += faults;
        counters.updateMs += updateClock.lap_ms();
    }
    return {std::move(predicted), std::move(search.associations), counters};
}

Belief& onlyBelief(Mixture& mixture)
{
    if (mixture.size() != 1)
        throw std::logic_error("this strategy takes a mixture of exactly one belief");
    return mixture.front().belief;
}
}  // namespace monoslam
