// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/jointCompatibility.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <limits>

namespace monoslam
{
namespace
{
/** L^-T L^-1 by blocks, so that the zeros of L^-1 cost nothing: a third of two solves. */
Eigen::MatrixXd inverseFromFactor(const Eigen::MatrixXd& L)
{
    constexpr Eigen::Index kBlock = 24;
    const Eigen::Index n = L.rows();
    Eigen::MatrixXd L_inverse = Eigen::MatrixXd::Identity(n, n);
    Eigen::MatrixXd inverse(n, n);
    for (Eigen::Index c = 0; c < n; c += kBlock)
    {
        auto columns = L_inverse.block(c, c, n - c, std::min(kBlock, n - c));
        L.bottomRightCorner(n - c, n - c).triangularView<Eigen::Lower>().solveInPlace(columns);
    }
    for (Eigen::Index c = 0; c < n; c += kBlock)
        for (Eigen::Index r = c; r < n; r += kBlock)
        {
            const Eigen::Index rows = std::min(kBlock, n - r), columns = std::min(kBlock, n - c);
            inverse.block(r, c, rows, columns).noalias() =
                L_inverse.block(r, r, n - r, rows).transpose() *
                L_inverse.block(r, c, n - r, columns);
        }
    inverse.triangularView<Eigen::StrictlyUpper>() = inverse.transpose();
    return inverse;
}
}  // namespace

double chi2Limit(Eigen::Index dof, double tau)
{
    if (dof <= 0) return 0.0;
    if (tau >= 1.0) return std::numeric_limits<double>::infinity();
    return boost::math::quantile(boost::math::chi_squared(static_cast<double>(dof)), tau);
}

Chi2Table::Chi2Table(double tau, Eigen::Index maxDof) : tau_(tau)
{
    quantiles_.reserve(static_cast<std::size_t>(maxDof) + 1);
    for (Eigen::Index dof = 0; dof <= maxDof; ++dof) quantiles_.push_back(chi2Limit(dof, tau));
}

double Chi2Table::operator()(Eigen::Index dof) const
{
    const auto index = static_cast<std::size_t>(std::max<Eigen::Index>(dof, 0));
    return index < quantiles_.size() ? quantiles_[index] : chi2Limit(dof, tau_);
}

IncrementalD2::IncrementalD2(const Eigen::MatrixXd& HPHt, Eigen::Index capacity)
    : HPHt_(HPHt),
      L_(2 * capacity, 2 * capacity),
      e_(2 * capacity),
      rows_(static_cast<std::size_t>(capacity)),
      d2_(static_cast<std::size_t>(capacity) + 1, 0.0)
{
}

bool IncrementalD2::push(const JointPair& pair)
{
    const Eigen::Index k = 2 * pairs_;
    double* y0 = L_.row(k).data();
    double* y1 = L_.row(k + 1).data();
    const auto column = HPHt_.middleCols<2>(2 * pair.row);
    for (Eigen::Index i = 0; i < pairs_; ++i)
    {
        const Eigen::Index r = 2 * rows_[static_cast<std::size_t>(i)];
        for (Eigen::Index a = 0; a < 2; ++a)
        {
            const Eigen::Index c = 2 * i + a;
            const auto solved = L_.row(c).head(c);
            const double scale = 1.0 / L_(c, c);
            y0[c] = (column(r + a, 0) - solved.dot(L_.row(k).head(c))) * scale;
            y1[c] = (column(r + a, 1) - solved.dot(L_.row(k + 1).head(c))) * scale;
        }
    }
    const auto Y0 = L_.row(k).head(k);
    const auto Y1 = L_.row(k + 1).head(k);
    const Eigen::Matrix2d S_jj = column.middleRows<2>(2 * pair.row) + pair.R;
    const double c00 = S_jj(0, 0) - Y0.squaredNorm();
    const double c10 = (S_jj(1, 0) - Y0.dot(Y1)) / std::sqrt(c00);
    const double c11 = S_jj(1, 1) - Y1.squaredNorm() - c10 * c10;
    if (!(c00 > 0.0) || !(c11 > 0.0)) return false;

    y0[k] = std::sqrt(c00);
    y1[k] = c10;
    y1[k + 1] = std::sqrt(c11);
    const auto e = e_.head(k).transpose();
    e_(k) = (pair.nu(0) - Y0.dot(e)) / y0[k];
    e_(k + 1) = (pair.nu(1) - Y1.dot(e) - c10 * e_(k)) / y1[k + 1];
    rows_[static_cast<std::size_t>(pairs_)] = pair.row;
    const double before = d2();
    ++pairs_;
    d2_[static_cast<std::size_t>(pairs_)] = before + e_.segment<2>(k).squaredNorm();
    return true;
}

DowndatingD2::DowndatingD2(const Eigen::MatrixXd& S, const Eigen::VectorXd& nu)
    : DowndatingD2(S.llt(), nu)
{
}

DowndatingD2::DowndatingD2(const Eigen::LLT<Eigen::MatrixXd>& factorOfS, const Eigen::VectorXd& nu)
    : removed_(static_cast<std::size_t>(nu.size() / 2), false)
{
    valid_ = factorOfS.info() == Eigen::Success && nu.allFinite();
    if (!valid_) return;
    Lam_ = inverseFromFactor(factorOfS.matrixLLT());
    gt_ = factorOfS.solve(nu);
    d2_ = nu.dot(gt_);
    valid_ = std::isfinite(d2_);
}

double DowndatingD2::conditionalNis(Eigen::Index pair) const
{
    const Eigen::Vector2d gt_j = gt_.segment<2>(2 * pair);
    const Eigen::Matrix2d Lam_jj = Lam_.block<2, 2>(2 * pair, 2 * pair);
    return gt_j.dot(Lam_jj.inverse() * gt_j);
}

void DowndatingD2::remove(Eigen::Index pair)
{
    const Eigen::Index j = 2 * pair;
    const Eigen::Matrix2d Sig_jj = Lam_.block<2, 2>(j, j).inverse();
    const Eigen::Matrix<double, Eigen::Dynamic, 2> Lam_j = Lam_.middleCols<2>(j);
    const Eigen::Matrix<double, Eigen::Dynamic, 2> K = Lam_j * Sig_jj;
    d2_ -= conditionalNis(pair);
    gt_.noalias() -= K * Eigen::Vector2d(gt_.segment<2>(j));
    Lam_.noalias() -= K.lazyProduct(Lam_j.transpose());
    removed_[static_cast<std::size_t>(pair)] = true;
}

Eigen::Index DowndatingD2::worst() const
{
    Eigen::Index worstPair = -1;
    double largest = -1.0;
    for (std::size_t j = 0; j < removed_.size(); ++j)
    {
        if (removed_[j]) continue;
        const double w = conditionalNis(static_cast<Eigen::Index>(j));
        if (w <= largest) continue;
        largest = w;
        worstPair = static_cast<Eigen::Index>(j);
    }
    return worstPair;
}
}  // namespace monoslam
