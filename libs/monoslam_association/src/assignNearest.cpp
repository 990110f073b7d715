// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/assignNearest.h"

#include <algorithm>
#include <set>

#include "assignmentOrders.h"
#include "monoslam_association/ConditionalPairs.h"

namespace monoslam
{
AssignmentResult assignNearest(const AssignmentProblem& problem)
{
    ConditionalPairs stack(problem);
    const CandidateOrder order = nearestFirst(problem, stack);
    std::vector<std::size_t> items;
    for (std::size_t i = 0; i < problem.items.size(); ++i)
        if (!order[i].empty()) items.push_back(i);
    std::stable_sort(items.begin(), items.end(),
                     [&](std::size_t a, std::size_t b)
                     { return order[a].front().cost < order[b].front().cost; });

    AssignmentResult result;
    result.chosen.assign(problem.items.size(), -1);
    std::set<Eigen::Index> used;
    for (const std::size_t i : items)
        for (const RankedCandidate& candidate : order[i])
        {
            const AssignmentPair& pair = problem.items[i][candidate.index];
            if (used.count(pair.use) > 0 || !stack.push(pair)) continue;
            used.insert(pair.use);
            result.chosen[i] = static_cast<int>(candidate.index);
            break;
        }
    result.pairs = stack.pairs();
    result.d2 = stack.d2();
    result.logDet = stack.logDet();
    return result;
}
}  // namespace monoslam
