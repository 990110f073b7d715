// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "monoslam_association/export.h"

namespace monoslam
{
/** m pairs with one candidate each, and the limit of D2 after i removals. */
struct SubsetProblem
{
    Eigen::MatrixXd S;           ///< joint innovation covariance, 2m x 2m [px^2]
    Eigen::VectorXd nu;          ///< [px]
    std::vector<double> limits;  ///< m + 1 entries, falling; after i removals, 0 for the empty set

    [[nodiscard]] Eigen::Index pairs() const { return nu.size() / 2; }
};

enum class SubsetSearch
{
    Printed,         ///< Algorithm 1 corrected: every subset, a full inversion at every node
    Downdate,        ///< every subset, by the gain of removing it
    BranchAndBound,  ///< keep/remove tree on the incremental distance, worst pair first
    Removal,         ///< tree of removals with a bound on the gain of further ones
    Reinsertion,     ///< from the greedy set: pairs put back, and what can be removed for them
    Greedy,          ///< worst pair first until compatible; not exact
    Automatic,       ///< greedy, then the tree searches in the order that its answer suggests
};

/** When an exact search gives up; it then returns the best set known. */
struct SubsetBudget
{
    double subsets = 2e5;  ///< of Printed and Downdate: sum of C(m, i)
    long nodes = 20000;    ///< of the tree searches, each counted by its work: 1 for a pair tested,
                           ///< 32 or 256 for a node with a bound; 2 ms or so in all
    double time_ms = std::numeric_limits<double>::infinity();  ///< of them; not reproducible
};

struct SubsetResult
{
    std::vector<Eigen::Index> removed;  ///< ascending
    double d2 = 0.0;                    ///< of the pairs kept
    bool valid = true;                  ///< false: S is not positive definite, all are removed
    bool proved = true;                 ///< nothing larger, or equal and closer, exists
    bool searched = false;              ///< the full set was not compatible
    long nodes = 0;
    long leaves = 0;
    long d2Evaluations = 0;
};

/** The largest jointly compatible subset, of least D2 among those (HOHCT).
 *
 *      least i for which min over |R| = i of D2(all \ R) <= limits[i],  and the minimiser R
 *
 * All methods but Greedy are exact and agree; ties have probability zero. O(m^3) at least.
 * \see algorithms 6 and hohct-fast 2 to 5 */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT SubsetResult largestCompatibleSubset(
    const SubsetProblem& problem, SubsetSearch method, const SubsetBudget& budget = {});
}  // namespace monoslam
