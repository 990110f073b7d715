// SPDX-License-Identifier: BSD-3-Clause
#include "RemovalBound.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "subsetSearches.h"

namespace monoslam
{
void RemovalBound::measure(const PairMatrix& Lam, const PairVector& gt)
{
    const Eigen::Index n = Lam.size();
    if (N_.rows() < n)
    {
        N_.resize(n, n);
        G_inverse_.resize(n, 3);
        C_.resize(n, 4);
        w_.resize(n);
        values_.resize(n);
        squares_.resize(n);
    }
    open_.resize(static_cast<std::size_t>(n));
    std::iota(open_.begin(), open_.end(), Eigen::Index{0});
    summed_ = 0;
    for (Eigen::Index j = 0; j < n; ++j)
    {
        const double a = 1.0 / std::sqrt(Lam.plane(0, 0)(j, j));
        const double b = Lam.plane(1, 0)(j, j) * a;
        const double c = 1.0 / std::sqrt(std::max(Lam.plane(1, 1)(j, j) - b * b,
                                                  std::numeric_limits<double>::min()));
        G_inverse_.row(j) << a, -a * b * c, c;
        const double u0 = a * gt(j, 0);
        const double u1 = c * (gt(j, 1) - b * u0);
        w_(j) = u0 * u0 + u1 * u1;
    }
    for (Eigen::Index j = 0; j < n; ++j) coupleWithLater(Lam, j);
    for (Eigen::Index j = 0; j < n; ++j) squares_(j) = N_.col(j).head(n).squaredNorm();
    strongest_ = open_;
    std::sort(strongest_.begin(), strongest_.end(),
              [this](Eigen::Index a, Eigen::Index b) { return squares_(a) > squares_(b); });
}

/** N_lj = sqrt(f + sqrt(f^2 - det^2)), 2 f the sum of squares of C_lj, for all l > j. */
void RemovalBound::coupleWithLater(const PairMatrix& Lam, Eigen::Index j)
{
    const Eigen::Index n = Lam.size() - j - 1;
    const double a = G_inverse_(j, 0), b = G_inverse_(j, 1), c = G_inverse_(j, 2);
    const Eigen::Ref<const Eigen::ArrayXd> g00 = G_inverse_.col(0).segment(j + 1, n);
    const Eigen::Ref<const Eigen::ArrayXd> g10 = G_inverse_.col(1).segment(j + 1, n);
    const Eigen::Ref<const Eigen::ArrayXd> g11 = G_inverse_.col(2).segment(j + 1, n);
    for (Eigen::Index row = 0; row < 2; ++row)
    {
        const PairMatrix::ConstPlane left = Lam.plane(row, 0), right = Lam.plane(row, 1);
        C_.col(row).head(n) = a * left.col(j).tail(n).array();
        C_.col(2 + row).head(n) =
            b * left.col(j).tail(n).array() + c * right.col(j).tail(n).array();
    }
    Eigen::Ref<Eigen::ArrayXd> c00 = C_.col(0).head(n), c10 = C_.col(1).head(n);
    Eigen::Ref<Eigen::ArrayXd> c01 = C_.col(2).head(n), c11 = C_.col(3).head(n);
    c10 = g10 * c00 + g11 * c10;
    c11 = g10 * c01 + g11 * c11;
    c00 *= g00;
    c01 *= g00;
    Eigen::Ref<Eigen::ArrayXd> N = N_.col(j).segment(j + 1, n).array();
    N = c00 * c11 - c01 * c10;
    c00 = 0.5 * (c00.square() + c01.square() + c10.square() + c11.square());
    N = (c00 + (c00.square() - N.square()).max(0.0).sqrt()).sqrt();
    N_(j, j) = 0.0;
    N_.row(j).segment(j + 1, n) = N_.col(j).segment(j + 1, n).transpose();
}

void RemovalBound::close(Eigen::Index j)
{
    strongest_.erase(std::find(strongest_.begin(), strongest_.end(), j));
    for (const Eigen::Index l : open_)
        if (N_(l, j) >= least_(l)) known_[static_cast<std::size_t>(l)] = 0;
}

void RemovalBound::drop(Eigen::Index j)
{
    open_.erase(std::find(open_.begin(), open_.end(), j));
    close(j);
}

void RemovalBound::sumLargest(Eigen::Index j)
{
    largest_.assign(static_cast<std::size_t>(summed_), 0.0);
    for (const Eigen::Index l : strongest_)
        if (N_(l, j) > largest_.back() && l != j) insertFalling(largest_, N_(l, j));
    double sum = 0.0;
    for (Eigen::Index x = 0; x < summed_; ++x)
        sums_(x, j) = sum += largest_[static_cast<std::size_t>(x)];
    least_(j) = largest_.back();
    known_[static_cast<std::size_t>(j)] = 1;
}

void RemovalBound::couple(Eigen::Index most)
{
    if (summed_ < most - 1)
    {
        summed_ = most - 1;
        if (sums_.rows() < summed_ || sums_.cols() < N_.cols()) sums_.resize(summed_, N_.cols());
        least_.resize(N_.cols());
        known_.assign(static_cast<std::size_t>(N_.cols()), 0);
    }
    for (const Eigen::Index j : open_)
        if (known_[static_cast<std::size_t>(j)] == 0) sumLargest(j);
}

bool RemovalBound::keepForced(double d2, Eigen::Index removed, const SubsetIncumbent& incumbent)
{
    const Eigen::Index most = incumbent.removals() - removed;
    for (;;)
    {
        const auto n = static_cast<Eigen::Index>(open_.size());
        if (n < 2) return false;
        couple(most);
        reachable_.clear(n);
        for (Eigen::Index x = 2; x <= most; ++x)
        {
            for (Eigen::Index k = 0; k < n; ++k)
            {
                const Eigen::Index j = open_[static_cast<std::size_t>(k)];
                const double s = sigma(j, x);
                values_(k) = s > 0.0 ? w_(j) / s : std::numeric_limits<double>::infinity();
            }
            reachable_.mark(values_.head(n), x, d2 - incumbent.threshold(removed + x));
        }
        if (!reachable_.any()) return false;
        closed_.clear();
        std::size_t left = 0;
        for (Eigen::Index k = 0; k < n; ++k)
        {
            const Eigen::Index j = open_[static_cast<std::size_t>(k)];
            if (reachable_[k])
                open_[left++] = j;
            else
                closed_.push_back(j);
        }
        open_.resize(left);
        if (closed_.empty()) return true;
        for (const Eigen::Index j : closed_) close(j);
    }
}
}  // namespace monoslam
