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
bool search(const SubsetProblem& problem, const DowndatingD2& whole, SubsetSearch method,
            const SubsetBudget& budget, SubsetIncumbent& incumbent, SubsetResult& result)
{
    NodeAllowance allowance(budget.nodes, budget.time_ms);
    allowance.openStage(budget.nodes);
    switch (method)
    {
        case SubsetSearch::Printed:
            return searchAsPrinted(problem, budget.subsets, incumbent, result);
        case SubsetSearch::Downdate:
            return searchByDowndating(problem, whole, budget.subsets, incumbent, result);
        case SubsetSearch::BranchAndBound:
            searchGreedily(problem, whole, incumbent, result);
            return searchByPrefixes(problem, whole, allowance, incumbent, result);
        case SubsetSearch::Removal:
            searchGreedily(problem, whole, incumbent, result);
            return searchByRemovals(whole, allowance, incumbent, result);
        case SubsetSearch::Reinsertion:
            searchGreedily(problem, whole, incumbent, result);
            return searchByReinsertions(whole, allowance, incumbent, result);
        case SubsetSearch::Automatic:
            return searchByPortfolio(problem, whole, allowance, incumbent, result);
        case SubsetSearch::Greedy:
            searchGreedily(problem, whole, incumbent, result);
            break;
    }
    return false;
}
}  // namespace

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
