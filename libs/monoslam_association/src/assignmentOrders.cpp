// SPDX-License-Identifier: BSD-3-Clause
#include "assignmentOrders.h"

#include <algorithm>
#include <cmath>

namespace monoslam
{
std::vector<RankedCandidate> nearestFirst(const std::vector<AssignmentPair>& item,
                                          const ConditionalPairs& stack, bool likelihood)
{
    std::vector<RankedCandidate> ranked;
    for (std::size_t c = 0; c < item.size(); ++c)
    {
        const ConditionalPairs::Gain gain = stack.gain(item[c]);
        const double cost = gain.nis + (likelihood ? gain.logDet : 0.0);
        if (std::isfinite(cost)) ranked.push_back({c, gain.nis, cost});
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const RankedCandidate& a, const RankedCandidate& b)
                     { return a.cost < b.cost; });
    return ranked;
}

CandidateOrder nearestFirst(const AssignmentProblem& problem, const ConditionalPairs& stack)
{
    CandidateOrder order;
    for (const auto& item : problem.items)
        order.push_back(nearestFirst(item, stack, problem.likelihood));
    return order;
}

JointPairs jointPairs(const AssignmentProblem& problem, const std::vector<int>& chosen)
{
    const Eigen::Index O = problem.dimension;
    JointPairs joint;
    std::vector<const AssignmentPair*> pairs;
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
        if (chosen[i] < 0) continue;
        joint.items.push_back(i);
        pairs.push_back(&problem.items[i][static_cast<std::size_t>(chosen[i])]);
    }
    const Eigen::Index n = O * static_cast<Eigen::Index>(pairs.size());
    joint.S.resize(n, n);
    joint.nu.resize(n);
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        const Eigen::Index row = O * static_cast<Eigen::Index>(i);
        joint.nu.segment(row, O) = pairs[i]->nu;
        for (std::size_t j = 0; j < pairs.size(); ++j)
            joint.S.block(row, O * static_cast<Eigen::Index>(j), O, O) =
                problem.HPHt.block(O * pairs[i]->block, O * pairs[j]->block, O, O);
        if (pairs[i]->R.size() > 0) joint.S.block(row, row, O, O) += pairs[i]->R;
    }
    return joint;
}
}  // namespace monoslam
