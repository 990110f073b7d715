// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>
#include <algorithm>

#include "PairMatrix.h"
#include "subsetSearches.h"

namespace monoslam
{
namespace
{
/** Pair of largest w given the removals so far, by a block Cholesky factorization of Lam that takes
 *  the removed pairs as pivots: only their columns are ever formed, O(m r) each. */
class PivotedRemovals
{
   public:
    PivotedRemovals(const DowndatingD2& whole, Eigen::Index most)
        : Lam_(whole.precision()),
          gt_(whole.weighted()),
          K_(gt_.size(), 2 * most),
          blocks_(static_cast<std::size_t>(gt_.size() / 2)),
          d2_(whole.d2())
    {
        for (std::size_t j = 0; j < blocks_.size(); ++j)
        {
            const Eigen::Index at = 2 * static_cast<Eigen::Index>(j);
            blocks_[j] = Lam_.block<2, 2>(at, at);
        }
    }

    [[nodiscard]] double d2() const { return d2_; }

    [[nodiscard]] Eigen::Index worst() const
    {
        Eigen::Index chosen = -1;
        double largest = -1.0;
        for (std::size_t j = 0; j < blocks_.size(); ++j)
        {
            const auto pair = static_cast<Eigen::Index>(j);
            if (std::find(removed_.begin(), removed_.end(), pair) != removed_.end()) continue;
            const Eigen::Matrix2d& B = blocks_[j];
            const double x = gt_(2 * pair), y = gt_(2 * pair + 1);
            const double w = (B(1, 1) * x * x - 2.0 * B(0, 1) * x * y + B(0, 0) * y * y) /
                             (B(0, 0) * B(1, 1) - B(0, 1) * B(0, 1));
            if (w <= largest) continue;
            largest = w;
            chosen = pair;
        }
        return chosen;
    }

    void remove(Eigen::Index j)
    {
        const Eigen::Index n = 2 * static_cast<Eigen::Index>(removed_.size());
        Eigen::MatrixX2d column = Lam_.middleCols<2>(2 * j);
        column.noalias() -= K_.leftCols(n) * K_.middleRows<2>(2 * j).leftCols(n).transpose();
        const Eigen::LLT<Eigen::Matrix2d> llt(Eigen::Matrix2d(column.middleRows<2>(2 * j)));
        llt.matrixU().solveInPlace<Eigen::OnTheRight>(column);
        const Eigen::Vector2d e = llt.matrixL().solve(gt_.segment<2>(2 * j));
        gt_.noalias() -= column * e;
        d2_ -= e.squaredNorm();
        for (std::size_t l = 0; l < blocks_.size(); ++l)
        {
            const Eigen::Matrix2d K_l = column.middleRows<2>(2 * static_cast<Eigen::Index>(l));
            blocks_[l] -= K_l * K_l.transpose();
        }
        K_.middleCols<2>(n) = column;
        removed_.push_back(j);
    }

   private:
    const Eigen::MatrixXd& Lam_;
    Eigen::VectorXd gt_;
    Eigen::MatrixXd K_;
    std::vector<Eigen::Matrix2d> blocks_;
    std::vector<Eigen::Index> removed_;
    double d2_;
};
}  // namespace

void searchGreedily(const SubsetProblem& problem, const DowndatingD2& whole,
                    SubsetIncumbent& incumbent, SubsetResult& result)
{
    PivotedRemovals pivots(whole, problem.pairs());
    std::vector<Eigen::Index> removed;
    while (static_cast<Eigen::Index>(removed.size()) < problem.pairs() &&
           pivots.d2() > problem.limits[removed.size()])
    {
        const Eigen::Index j = pivots.worst();
        result.d2Evaluations += problem.pairs() - static_cast<Eigen::Index>(removed.size());
        if (j < 0) break;
        pivots.remove(j);
        removed.push_back(j);
    }
    const auto count = static_cast<Eigen::Index>(removed.size());
    if (count < incumbent.removals() && pivots.d2() <= problem.limits[removed.size()])
        incumbent.replace(std::move(removed), pivots.d2());
}
}  // namespace monoslam
