// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "monoslam_association/BatchAssociator.h"

namespace monoslam
{
struct ConsensusOptions
{
    double th_sigma = 2.0;     ///< inlier threshold in standard deviations of a match
    double p = 0.99;           ///< wanted probability of one outlier-free hypothesis
    int enumerate_up_to = 50;  ///< matches; with more, hypotheses are drawn
};

/** Matches of a frame, one candidate each, and the belief that they were predicted from. */
struct ConsensusProblem
{
    const Belief& prior;
    const FrameView& view;
    const AssociationProblem& matches;
};

/** One match gives a state; the state that most matches agree with in the image gives the inliers.
 *
 *      x' = x + P H_k' S_k^-1 (z_k - h_k),   inliers = { j : |z_j - h_j(x')| < th_sigma sigma_j }
 *
 * Only the mean moves, and all matches are reprojected by the non-linear model; O(n) per hypothesis
 * of n matches, beside O(N) for x'. Every match makes a hypothesis up to enumerate_up_to matches;
 * with more, matches are drawn until log(1 - p) / log(outlier share) hypotheses were looked at.
 * \return 0 for every inlier, -1 else; \see Civera et al., IROS 2009 */
[[nodiscard]] std::vector<int> largestConsensus(const ConsensusProblem& problem,
                                                const ConsensusOptions& options,
                                                AssociationCounters& counters, std::mt19937& rng);
}  // namespace monoslam
