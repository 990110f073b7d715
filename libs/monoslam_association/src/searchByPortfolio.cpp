// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <limits>

#include "subsetSearches.h"

namespace monoslam
{
namespace
{
/** Beyond this share of removals the trees of removals and re-insertions grow fast; the prefix
 *  tree, whose nodes are cheap, then comes first. */
constexpr double kFewRemovals = 0.15;
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
constexpr StagePlan kManyRemovals[] = {{Stage::Prefixes, 6000},
                                       {Stage::Reinsertions, 8000},
                                       {Stage::Prefixes, 20000},
                                       {Stage::Removals, 40000},
                                       {Stage::Reinsertions, kAllThatIsLeft}};
constexpr StagePlan kFew[] = {{Stage::Reinsertions, 8000},
                              {Stage::Prefixes, 6000},
                              {Stage::Removals, 40000},
                              {Stage::Reinsertions, kAllThatIsLeft}};
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
    const auto m = static_cast<double>(problem.pairs());
    const bool many = problem.pairs() <= kFewPairs ||
                      static_cast<double>(incumbent.removals()) > kFewRemovals * m;
    if (many) return std::any_of(std::begin(kManyRemovals), std::end(kManyRemovals), run);
    return std::any_of(std::begin(kFew), std::end(kFew), run);
}
}  // namespace monoslam
