// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_association/ConditionalPairs.h"

namespace monoslam
{
struct RankedCandidate
{
    std::size_t index = 0;  ///< in the item
    double nis = 0.0;       ///< given the stack
    double cost = 0.0;      ///< nis, or twice the negative log-likelihood but for a constant
};
/** Candidates of each item. */
using CandidateOrder = std::vector<std::vector<RankedCandidate>>;

/** Candidates of one item, best first given the stack; those that have no distance left out. */
[[nodiscard]] std::vector<RankedCandidate> nearestFirst(const std::vector<AssignmentPair>& item,
                                                        const ConditionalPairs& stack,
                                                        bool likelihood);
[[nodiscard]] CandidateOrder nearestFirst(const AssignmentProblem& problem,
                                          const ConditionalPairs& stack);

/** Joint S and nu of the chosen pairs. */
struct JointPairs
{
    std::vector<std::size_t> items;
    Eigen::MatrixXd S;
    Eigen::VectorXd nu;
};
[[nodiscard]] JointPairs jointPairs(const AssignmentProblem& problem,
                                    const std::vector<int>& chosen);
}  // namespace monoslam
