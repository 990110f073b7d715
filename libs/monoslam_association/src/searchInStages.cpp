// SPDX-License-Identifier: BSD-3-Clause
// The order of search and decision of batch strategies, and what is recorded of it.
#include <algorithm>
#include <utility>

#include "BatchSearch.h"
#include "ConditionalPrediction.h"
#include "monoslam_support/ThreadClock.h"
#include "relinearize.h"

namespace monoslam
{
std::vector<int> searchInStages(BatchSearch& search, Belief& prior, const FrameView& view,
                                const DecideFn& decide)
{
    ThreadClock clock;
    AssociationCounters& counters = search.counters;
    search.searchFirstStage();
    counters.searchMs += clock.lap_ms();
    std::vector<int> accepted = decide(search);
    counters.selectMs += clock.lap_ms();
    const auto known = pixelsOf(search.problem(), accepted);
    if (search.settings().options.max_iterations > 1 && known.size() >= kPoseFixingPairs)
    {
        Eigen::VectorXd mean = ekfUpdateMean(prior, search.prediction(), known);
        const bool enough = linearEnough(search.prediction(), known, prior, mean, view);
        if (!enough)
        {
            search.linearizedAt = std::move(mean);
            search.moveTo(predictAt(view, prior, search.linearizedAt));
        }
        counters.updateMs += clock.lap_ms();
        if (!enough) accepted = decide(search);
        counters.selectMs += clock.lap_ms();
    }
    const bool undecided = search.searchRest(accepted);
    counters.searchMs += clock.lap_ms();
    if (undecided) accepted = decide(search);
    counters.selectMs += clock.lap_ms();
    return accepted;
}

void recordPairs(const AssociationProblem& problem, const std::vector<int>& chosen,
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
}  // namespace monoslam
