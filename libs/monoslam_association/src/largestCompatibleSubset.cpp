// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/largestCompatibleSubset.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "subsetSearches.h"

namespace monoslam
{
namespace
{
/** With more pairs trees over kept pairs hardly ever end. */
constexpr Eigen::Index kFewPairs = 30;
/** Up to this share of removals the removal tree has next to no nodes. */
constexpr double kFewRemovals = 0.15;
/** A node of the removal tree costs about as much as this many prefix nodes. */
constexpr long kRemovalNodeCost = 50;

bool searchAutomatically(const SubsetProblem& problem, const DowndatingD2& whole, long maxNodes,
                         SubsetIncumbent& incumbent, SubsetResult& result)
{
    searchGreedily(problem, whole, incumbent, result);
    const auto prefixes = [&]
    { return searchByPrefixes(problem, whole, maxNodes, incumbent, result); };
    const auto removals = [&]
    {
        const long nodes = std::max(1L, maxNodes / kRemovalNodeCost);
        return searchByRemovals(problem, whole, nodes, incumbent, result);
    };
    const auto m = static_cast<double>(problem.pairs());
    const bool prefixesFirst = problem.pairs() <= kFewPairs &&
                               static_cast<double>(incumbent.removals()) > kFewRemovals * m;
    return prefixesFirst ? prefixes() || removals() : removals() || prefixes();
}

bool search(const SubsetProblem& problem, const DowndatingD2& whole, SubsetSearch method,
            const SubsetBudget& budget, SubsetIncumbent& incumbent, SubsetResult& result)
{
    switch (method)
    {
        case SubsetSearch::Printed:
            return searchAsPrinted(problem, budget.subsets, incumbent, result);
        case SubsetSearch::Downdate:
            return searchByDowndating(problem, whole, budget.subsets, incumbent, result);
        case SubsetSearch::BranchAndBound:
            searchGreedily(problem, whole, incumbent, result);
            return searchByPrefixes(problem, whole, budget.nodes, incumbent, result);
        case SubsetSearch::Removal:
            searchGreedily(problem, whole, incumbent, result);
            return searchByRemovals(problem, whole, budget.nodes, incumbent, result);
        case SubsetSearch::Automatic:
            return searchAutomatically(problem, whole, budget.nodes, incumbent, result);
        case SubsetSearch::Greedy:
            break;
    }
    searchGreedily(problem, whole, incumbent, result);
    return false;
}
}  // namespace

void searchGreedily(const SubsetProblem& problem, DowndatingD2 whole, SubsetIncumbent& incumbent,
                    SubsetResult& result)
{
    std::vector<Eigen::Index> removed;
    while (static_cast<Eigen::Index>(removed.size()) < problem.pairs() &&
           whole.d2() > problem.limits[removed.size()])
    {
        const Eigen::Index j = whole.worst();
        result.d2Evaluations += problem.pairs() - static_cast<Eigen::Index>(removed.size());
        if (j < 0) break;
        whole.remove(j);
        removed.push_back(j);
    }
    const auto count = static_cast<Eigen::Index>(removed.size());
    if (count < incumbent.removals() && whole.d2() <= problem.limits[removed.size()])
        incumbent.replace(std::move(removed), whole.d2());
}

SubsetResult largestCompatibleSubset(const SubsetProblem& problem, SubsetSearch method,
                                     const SubsetBudget& budget)
{
    const Eigen::Index m = problem.pairs();
    if (problem.S.rows() != 2 * m || static_cast<Eigen::Index>(problem.limits.size()) != m + 1)
        throw std::invalid_argument("largestCompatibleSubset: sizes of S, nu and limits disagree");
    SubsetResult result;
    if (m == 0) return result;
    SubsetIncumbent incumbent(problem);
    const Eigen::LLT<Eigen::MatrixXd> llt(problem.S);
    const double d2 = llt.matrixL().solve(problem.nu).squaredNorm();
    result.d2Evaluations = 1;
    result.valid = llt.info() == Eigen::Success && std::isfinite(d2);
    if (result.valid && d2 <= problem.limits.front())
    {
        result.d2 = d2;
        return result;
    }
    if (result.valid)
    {
        result.searched = true;
        const DowndatingD2 whole(llt, problem.nu);
        result.proved = search(problem, whole, method, budget, incumbent, result);
    }
    result.removed = incumbent.removed();
    std::sort(result.removed.begin(), result.removed.end());
    result.d2 = incumbent.d2();
    return result;
}
}  // namespace monoslam
