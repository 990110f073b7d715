// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

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
    /** Opens \p n pairs. \param Lam, gt  their precision and weighted innovation, leading part */
    void measure(const Eigen::MatrixXd& Lam, const Eigen::VectorXd& gt, Eigen::Index n);

    /** Closes every pair that is kept in each better set with \p removed + 2 or more removals.
     *  \return false if no such set exists; sigma() is valid for the pairs left if true */
    bool keepForced(double d2, Eigen::Index removed, const SubsetIncumbent& incumbent);

    void drop(Eigen::Index j);
    [[nodiscard]] const std::vector<Eigen::Index>& open() const { return open_; }
    [[nodiscard]] double gain(Eigen::Index j) const { return w_[static_cast<std::size_t>(j)]; }
    /** For the largest number of removals asked about. */
    [[nodiscard]] double sigma(Eigen::Index j) const { return sigma_[static_cast<std::size_t>(j)]; }

   private:
    void couplings(std::size_t most);
    bool markReachable(double needed, std::size_t x);

    Eigen::MatrixXd N_;
    std::vector<Eigen::Matrix2d> G_inverse_;
    std::vector<double> w_, sigma_, values_, largest_;
    std::vector<std::vector<double>> sums_;  ///< of the 1, 2, ... largest N_jl
    std::vector<char> reachable_;
    std::vector<Eigen::Index> open_;
};
}  // namespace monoslam
