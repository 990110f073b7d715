// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "PairMatrix.h"
#include "ReachablePairs.h"

namespace monoslam
{
class SubsetIncumbent;

/** Upper bound on the gain in D2 of removing any x of the open pairs (hohct-fast 3).
 *
 *      Lam_jj = G_j G_j',  N_jl = |G_j^-1 Lam_jl G_l^-T|,  w_j = |G_j^-1 gt_j|^2
 *      sigma_j(x) = 1 - (sum of the x - 1 largest N_jl over open l)
 *      gain(X) <= sum over X of w_j / sigma_j(|X|)                  (block Gershgorin), inf if <= 0
 */
class RemovalBound
{
   public:
    /** Opens all pairs of \p Lam, their precision; \p gt is their weighted innovation. */
    void measure(const PairMatrix& Lam, const PairVector& gt);

    /** Makes sigma() of the open pairs known for 2 to \p most removals. */
    void couple(Eigen::Index most);

    /** Closes every pair that is kept in each better set with \p removed + 2 or more removals.
     *  \return false if no such set exists; sigma() is valid for the pairs left if true */
    bool keepForced(double d2, Eigen::Index removed, const SubsetIncumbent& incumbent);

    void drop(Eigen::Index j);
    [[nodiscard]] const std::vector<Eigen::Index>& open() const { return open_; }
    [[nodiscard]] double gain(Eigen::Index j) const { return w_(j); }
    /** For x >= 2 removals, no more than were asked for. */
    [[nodiscard]] double sigma(Eigen::Index j, Eigen::Index x) const
    {
        return 1.0 - sums_(x - 2, j);
    }

   private:
    void coupleWithLater(const PairMatrix& Lam, Eigen::Index j);
    void sumLargest(Eigen::Index j);
    void sumLargestTogether(Eigen::Index j);
    template <class Largest>
    void setSums(Eigen::Index j, const Largest& largest);
    void close(Eigen::Index j);

    static constexpr Eigen::Index kTogether = 8;

    Eigen::Index n_ = 0;  ///< pairs, open or not
    Eigen::MatrixXd N_;
    Eigen::ArrayX3d G_inverse_;  ///< (0, 0), (1, 0), (1, 1) of each pair
    Eigen::ArrayXd w_, values_;
    Eigen::MatrixXd sums_;     ///< column j: of the 1, 2, ... largest N_jl
    Eigen::VectorXd least_;    ///< of the N_jl summed
    Eigen::Index summed_ = 0;  ///< rows of sums_ in use
    std::vector<char> known_;  ///< column j of sums_ is up to date
    std::vector<double> largest_;
    std::vector<Eigen::Array<double, kTogether, 1>> largestTogether_;
    ReachablePairs reachable_;
    std::vector<Eigen::Index> open_, closed_;
    Eigen::ArrayXd squares_;               ///< sum of the N_jl^2
    std::vector<Eigen::Index> strongest_;  ///< the open ones, most strongly coupled first
};
}  // namespace monoslam
