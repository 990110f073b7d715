// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "monoslam_association/export.h"
#include "monoslam_association/jointCompatibility.h"

namespace monoslam
{
/** Pairs that JCBB chooses from: pairs[i] are the candidates of the i-th landmark. */
struct JcbbProblem
{
    const Eigen::MatrixXd* HPHt = nullptr;
    std::vector<std::vector<JointPair>> pairs;         ///< of one row each, nearest first
    std::vector<std::vector<Eigen::Vector2d>> pixels;  ///< where they are [px]; empty: never equal
};

struct JcbbOptions
{
    bool bound = true;     ///< skip branches that cannot beat the best; false as in the paper
    long node_cap = 2000;  ///< then the best set so far is returned
};

struct JcbbResult
{
    std::vector<int> chosen;  ///< candidate of each landmark, -1 = none
    double d2 = 0.0;
    bool finished = true;   ///< false: the node cap ended the search
    bool searched = false;  ///< the full set of nearest candidates was not compatible
    long nodes = 0;
    long leaves = 0;
    long d2Evaluations = 0;
};

/** Joint compatibility branch and bound.
 *
 * Depth first over the landmarks, each candidate and then none; a branch is cut when its D2 exceeds
 * chi2(2 pairs), or, with the bound, when it cannot have more pairs than the best set, or as many
 * at a lesser D2. Two landmarks are never given the same pixel. The full set is tried first.
 * The limit of a prefix is lower than that of the set: the answer depends on the order of the
 * landmarks and can be smaller than HOHCT's.
 * \see Neira, Tardos, "Data association in stochastic mapping using the joint compatibility test",
 *      2001 */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT JcbbResult jointBranchAndBound(
    const JcbbProblem& problem, const Chi2Table& limits, const JcbbOptions& options);
}  // namespace monoslam
