// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <limits>

#include "subsetSearches.h"

namespace monoslam
{
namespace
{
/** Up to this share of removals hardly any pair of the greedy set is doubtful. */
constexpr double kFewRemovals = 0.15;
/** Up to this number of pairs the removal tree ends before a re-insertion is set up. */
constexpr Eigen::Index kFewPairs = 16;

enum class Stage
{
    Prefixes,
    Reinsertions,
    Removals,
};

/** A stage and the work after which the next one is tried, in nodes of the prefix tree. */
struct StagePlan
{
    Stage stage;
    long work;
};
constexpr long kAllThatIsLeft = std::numeric_limits<long>::max();
/** Re-insertions prove a good greedy set at once; around a bad one they would go on for ever, where
 *  the removal tree, which does not depend on it, ends. */
constexpr StagePlan kManyRemovals[] = {{Stage::Prefixes, 6000},
                                       {Stage::Reinsertions, 40000},
                                       {Stage::Removals, 240000},
                                       {Stage::Prefixes, 20000},
                                       {Stage::Removals, kAllThatIsLeft}};
constexpr StagePlan kFewRemovalsPlan[] = {
    {Stage::Reinsertions, 40000}, {Stage::Prefixes, 6000}, {Stage::Removals, kAllThatIsLeft}};
constexpr StagePlan kFewPairsPlan[] = {
    {Stage::Removals, 16000}, {Stage::Prefixes, 20000}, {Stage::Removals, kAllThatIsLeft}};
}  // namespace

bool searchByPortfolio(const SubsetProblem& problem, const DowndatingD2& whole,
                       NodeAllowance& allowance, SubsetIncumbent& incumbent, SubsetResult& result)
{
    const auto run = [&](const StagePlan& plan)
    {
        allowance.openStage(plan.work);
        switch (plan.stage)
        {
            case Stage::Prefixes:
                return searchByPrefixes(problem, whole, allowance, incumbent, result);
            case Stage::Removals:
                return searchByRemovals(whole, allowance, incumbent, result);
            case Stage::Reinsertions:
                break;
        }
        return searchByReinsertions(whole, allowance, incumbent, result);
    };
    searchGreedily(problem, whole, incumbent, result);
    const auto tryEach = [&run](const auto& plans)
    { return std::any_of(std::begin(plans), std::end(plans), run); };
    const auto m = static_cast<double>(problem.pairs());
    if (problem.pairs() <= kFewPairs) return tryEach(kFewPairsPlan);
    const bool few = static_cast<double>(incumbent.removals()) <= kFewRemovals * m;
    return few ? tryEach(kFewRemovalsPlan) : tryEach(kManyRemovals);
}
}  // namespace monoslam
