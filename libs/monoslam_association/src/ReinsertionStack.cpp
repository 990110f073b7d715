// SPDX-License-Identifier: BSD-3-Clause
#include "ReinsertionStack.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace monoslam
{
ReinsertionStack::ReinsertionStack(const ReinsertionReference& reference)
    : reference_(reference),
      L_(reference.nu.size(), reference.nu.size()),
      e_(reference.nu.size()),
      Omt_(2 * reference.Lam.size(), reference.nu.size()),
      values_(reference.Lam.size())
{
    const Eigen::Index k = reference.Lam.size();
    Level& level = levelAt(0);
    level.gt = reference.gt;
    level.d2 = reference.d2;
    for (Eigen::Index j = 0; j < k; ++j)
    {
        const Eigen::Matrix2d Lam_jj = reference.Lam.block(j, j);
        level.diagonal.row(j) << Lam_jj(0, 0), Lam_jj(1, 0), Lam_jj(1, 1);
    }
}

ReinsertionStack::Level& ReinsertionStack::levelAt(Eigen::Index depth)
{
    const Eigen::Index k = reference_.Lam.size();
    while (static_cast<Eigen::Index>(levels_.size()) <= depth)
    {
        Level& level = levels_.emplace_back();
        level.diagonal.resize(k, 3);
        level.gt.resize(k, 2);
        level.gain.resize(k);
        level.mostGain.resize(k);
    }
    return levels_[static_cast<std::size_t>(depth)];
}

double ReinsertionStack::d2() const
{
    return top().d2;
}
double ReinsertionStack::largestGain() const
{
    return top().gain.maxCoeff();
}

std::vector<Eigen::Index> ReinsertionStack::removed() const
{
    std::vector<Eigen::Index> without;
    Eigen::Index level = 1;
    for (Eigen::Index y = 0; y < static_cast<Eigen::Index>(reference_.removed.size()); ++y)
        if (level <= depth_ && levels_[static_cast<std::size_t>(level)].y == y)
            ++level;
        else
            without.push_back(reference_.removed[static_cast<std::size_t>(y)]);
    return without;
}

/** Rows of L, e and Om of one more pair. */
void ReinsertionStack::regress(Eigen::Index y)
{
    const Eigen::Index n = 2 * depth_;
    const Eigen::MatrixXd& Sig = reference_.Sig;
    for (Eigen::Index row = n; row < n + 2; ++row)
    {
        const Eigen::Index of = 2 * y + row - n;
        Omt_.col(row) = reference_.Wt.col(of);
        e_(row) = reference_.nu(of);
        double variance = Sig(of, of);
        for (Eigen::Index c = 0; c < row; ++c)
        {
            const Eigen::Index other =
                2 * (c < n ? levels_[static_cast<std::size_t>(c / 2 + 1)].y : y) + c % 2;
            const double covariance = Sig(of, other) - L_.row(row).head(c).dot(L_.row(c).head(c));
            L_(row, c) = covariance / L_(c, c);
            Omt_.col(row) -= L_(row, c) * Omt_.col(c);
            e_(row) -= L_(row, c) * e_(c);
            variance -= L_(row, c) * L_(row, c);
        }
        L_(row, row) = std::sqrt(std::max(variance, std::numeric_limits<double>::min()));
        Omt_.col(row) /= L_(row, row);
        e_(row) /= L_(row, row);
    }
}

void ReinsertionStack::push(Eigen::Index y)
{
    regress(y);
    Level& next = levelAt(depth_ + 1);
    const Level& level = top();
    const Eigen::Index k = reference_.Lam.size();
    next.y = y;
    next.d2 = level.d2;
    next.gt = level.gt;
    next.diagonal = level.diagonal;
    for (Eigen::Index row = 2 * depth_; row < 2 * depth_ + 2; ++row)
    {
        const Eigen::Ref<const Eigen::ArrayXd> Om_0 = Omt_.col(row).head(k).array();
        const Eigen::Ref<const Eigen::ArrayXd> Om_1 = Omt_.col(row).tail(k).array();
        next.d2 += e_(row) * e_(row);
        next.gt.col(0) -= e_(row) * Om_0;
        next.gt.col(1) -= e_(row) * Om_1;
        next.diagonal.col(0) += Om_0.square();
        next.diagonal.col(1) += Om_0 * Om_1;
        next.diagonal.col(2) += Om_1.square();
    }
    ++depth_;
    const Eigen::Ref<const Eigen::ArrayXd> x = next.gt.col(0), z = next.gt.col(1);
    const Eigen::ArrayX3d& D = next.diagonal;
    const Eigen::ArrayX3d& Sig = reference_.Sig_diagonal;
    next.gain = (D.col(2) * x.square() - 2.0 * D.col(1) * x * z + D.col(0) * z.square()) /
                (D.col(0) * D.col(2) - D.col(1).square());
    next.mostGain = Sig.col(0) * x.square() + 2.0 * Sig.col(1) * x * z + Sig.col(2) * z.square();
}

bool ReinsertionStack::findReachable(Eigen::Index base, const SubsetIncumbent& incumbent)
{
    const Level& level = top();
    const Eigen::Index k = reference_.Lam.size();
    const Eigen::Index most = incumbent.removals() - base;
    reachable_.clear(k);
    if (most >= 1) reachable_.mark(level.gain, 1, level.d2 - incumbent.threshold(base + 1));
    for (Eigen::Index x = 2; x <= most; ++x)
    {
        for (Eigen::Index j = 0; j < k; ++j)
        {
            const double sigma = reference_.bound.sigma(j, x);
            values_(j) =
                sigma > 0.0 ? level.mostGain(j) / sigma : std::numeric_limits<double>::infinity();
        }
        reachable_.mark(values_, x, level.d2 - incumbent.threshold(base + x));
    }
    return reachable_.any();
}

void ReinsertionStack::copyReachable(RemovalTree::Node& node) const
{
    const Level& level = top();
    std::vector<Eigen::Index> columns;
    node.pairs.clear();
    for (Eigen::Index j = 0; j < reference_.Lam.size(); ++j)
    {
        if (!reachable_[j]) continue;
        columns.push_back(j);
        node.pairs.push_back(reference_.kept[static_cast<std::size_t>(j)]);
    }
    const auto n = static_cast<Eigen::Index>(columns.size());
    const Eigen::Index k = reference_.Lam.size();
    Eigen::MatrixXd M(2 * n, 2 * depth_);
    if (node.gt.rows() < n) node.gt.resize(n, 2);
    for (Eigen::Index l = 0; l < n; ++l)
    {
        const Eigen::Index j = columns[static_cast<std::size_t>(l)];
        node.gt.row(l) = level.gt.row(j);
        M.row(l) = Omt_.row(j).head(2 * depth_);
        M.row(n + l) = Omt_.row(k + j).head(2 * depth_);
    }
    node.Lam.gather(reference_.Lam, columns);
    node.Lam.addSquare(M, 1.0);
    node.d2 = level.d2;
}
}  // namespace monoslam
