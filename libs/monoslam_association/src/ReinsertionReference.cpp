// SPDX-License-Identifier: BSD-3-Clause
#include "ReinsertionReference.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <numeric>

namespace monoslam
{
namespace
{
/** Rows and columns of some pairs, in the usual order. */
Eigen::MatrixXd blockOf(const Eigen::MatrixXd& Lam, const std::vector<Eigen::Index>& pairs)
{
    const auto n = static_cast<Eigen::Index>(pairs.size());
    Eigen::MatrixXd block(2 * n, 2 * n);
    for (Eigen::Index l = 0; l < n; ++l)
        for (Eigen::Index j = 0; j < n; ++j)
            block.block<2, 2>(2 * l, 2 * j) = Lam.block<2, 2>(
                2 * pairs[static_cast<std::size_t>(l)], 2 * pairs[static_cast<std::size_t>(j)]);
    return block;
}

Eigen::VectorXd segmentsOf(const Eigen::VectorXd& gt, const std::vector<Eigen::Index>& pairs)
{
    Eigen::VectorXd segments(2 * static_cast<Eigen::Index>(pairs.size()));
    for (std::size_t l = 0; l < pairs.size(); ++l)
        segments.segment<2>(2 * static_cast<Eigen::Index>(l)) = gt.segment<2>(2 * pairs[l]);
    return segments;
}

/** Descending nu_y' Sig_yy^-1 nu_y. */
void sortFarthestFirst(const DowndatingD2& whole, std::vector<Eigen::Index>& removed)
{
    const Eigen::MatrixXd Sig =
        blockOf(whole.precision(), removed)
            .llt()
            .solve(Eigen::MatrixXd::Identity(2 * static_cast<Eigen::Index>(removed.size()),
                                             2 * static_cast<Eigen::Index>(removed.size())));
    const Eigen::VectorXd nu = Sig * segmentsOf(whole.weighted(), removed);
    std::vector<std::pair<double, Eigen::Index>> keyed;
    for (std::size_t y = 0; y < removed.size(); ++y)
    {
        const Eigen::Index at = 2 * static_cast<Eigen::Index>(y);
        const Eigen::Matrix2d Sig_yy = Sig.block<2, 2>(at, at);
        const Eigen::Vector2d nu_y = nu.segment<2>(at);
        keyed.emplace_back(-nu_y.dot(Sig_yy.inverse() * nu_y), removed[y]);
    }
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t y = 0; y < removed.size(); ++y) removed[y] = keyed[y].second;
}
}  // namespace

ReinsertionReference::ReinsertionReference(const DowndatingD2& whole,
                                           std::vector<Eigen::Index> removedPairs)
    : removed(std::move(removedPairs))
{
    sortFarthestFirst(whole, removed);
    const Eigen::Index m = whole.weighted().size() / 2;
    std::vector<char> isRemoved(static_cast<std::size_t>(m), 0);
    for (const Eigen::Index j : removed) isRemoved[static_cast<std::size_t>(j)] = 1;
    for (Eigen::Index j = 0; j < m; ++j)
        if (isRemoved[static_cast<std::size_t>(j)] == 0) kept.push_back(j);
    const auto r = static_cast<Eigen::Index>(removed.size());
    const auto k = static_cast<Eigen::Index>(kept.size());

    const Eigen::LLT<Eigen::MatrixXd> llt(blockOf(whole.precision(), removed));
    const Eigen::VectorXd gt_R = segmentsOf(whole.weighted(), removed);
    const Eigen::VectorXd e = llt.matrixL().solve(gt_R);
    Sig = llt.solve(Eigen::MatrixXd::Identity(2 * r, 2 * r));
    nu = Sig * gt_R;

    Eigen::MatrixXd M(2 * k, 2 * r);  // Lam_KR, then times the inverse of the factor of Lam_RR
    for (Eigen::Index y = 0; y < r; ++y)
        M.middleCols<2>(2 * y) = gatherRows(
            whole.precision().middleCols<2>(2 * removed[static_cast<std::size_t>(y)]), kept);
    Wt.noalias() = -M * Sig;
    if (k > 0) llt.matrixU().solveInPlace<Eigen::OnTheRight>(M);
    gt = (gatherRows(whole.weighted(), kept) - M * e).reshaped(k, 2);
    d2 = whole.d2() - e.squaredNorm();
    Lam.gather(whole.precision(), kept);
    Lam.addSquare(M, -1.0);

    Sig_diagonal.resize(k, 3);
    for (Eigen::Index j = 0; j < k; ++j)
    {
        const Eigen::Matrix2d Sig_jj = Lam.block(j, j).inverse();
        Sig_diagonal.row(j) << Sig_jj(0, 0), Sig_jj(1, 0), Sig_jj(1, 1);
    }
    bound.measure(Lam, gt);
    bound.couple(std::max<Eigen::Index>(r, 2));
}
}  // namespace monoslam
