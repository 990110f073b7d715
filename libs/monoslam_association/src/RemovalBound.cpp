// SPDX-License-Identifier: BSD-3-Clause
#include "RemovalBound.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "subsetSearches.h"

namespace monoslam
{
namespace
{
/** Sets this close to the threshold are not excluded: the bound is rounded too. */
constexpr double kPruneMargin = 1e-9;

/** Inverse of the Cholesky factor of a 2 x 2 block. */
Eigen::Matrix2d inverseFactor(const Eigen::Matrix2d& A)
{
    const double a = std::sqrt(A(0, 0));
    const double b = A(1, 0) / a;
    const double c = std::sqrt(std::max(A(1, 1) - b * b, 1e-300));
    Eigen::Matrix2d G_inverse;
    G_inverse << 1.0 / a, 0.0, -b / (a * c), 1.0 / c;
    return G_inverse;
}

double spectralNorm(const Eigen::Matrix2d& C)
{
    const double half = 0.5 * C.squaredNorm();
    const double determinant = C(0, 0) * C(1, 1) - C(0, 1) * C(1, 0);
    const double root = std::sqrt(std::max(half * half - determinant * determinant, 0.0));
    return std::sqrt(half + root);
}
/** Puts a value into a falling list in place of its last one. */
void insert(std::vector<double>& falling, double value)
{
    std::size_t at = falling.size() - 1;
    for (; at > 0 && falling[at - 1] < value; --at) falling[at] = falling[at - 1];
    falling[at] = value;
}
}  // namespace

void RemovalBound::measure(const Eigen::MatrixXd& Lam, const Eigen::VectorXd& gt, Eigen::Index n)
{
    const auto count = static_cast<std::size_t>(n);
    w_.resize(count);
    sigma_.assign(count, 1.0);
    if (sums_.size() < count) sums_.resize(count);
    if (N_.rows() < n) N_.resize(n, n);
    open_.resize(count);
    std::iota(open_.begin(), open_.end(), Eigen::Index{0});
    G_inverse_.resize(count);
    for (Eigen::Index j = 0; j < n; ++j)
    {
        const auto index = static_cast<std::size_t>(j);
        G_inverse_[index] = inverseFactor(Lam.block<2, 2>(2 * j, 2 * j));
        w_[index] = (G_inverse_[index] * gt.segment<2>(2 * j)).squaredNorm();
        for (Eigen::Index l = 0; l < j; ++l)
        {
            const Eigen::Matrix2d C = G_inverse_[index] * Lam.block<2, 2>(2 * j, 2 * l) *
                                      G_inverse_[static_cast<std::size_t>(l)].transpose();
            N_(j, l) = N_(l, j) = spectralNorm(C);
        }
    }
}

void RemovalBound::drop(Eigen::Index j)
{
    open_.erase(std::find(open_.begin(), open_.end(), j));
}

void RemovalBound::couplings(std::size_t most)
{
    for (const Eigen::Index j : open_)
    {
        auto& largest = sums_[static_cast<std::size_t>(j)];
        largest.assign(most, 0.0);
        for (const Eigen::Index l : open_)
            if (l != j && N_(l, j) > largest.back()) insert(largest, N_(l, j));
        std::partial_sum(largest.begin(), largest.end(), largest.begin());
        sigma_[static_cast<std::size_t>(j)] = 1.0 - largest.back();
    }
}

/** Marks the pairs that may be among x removals that gain \p needed; false if no x can. */
bool RemovalBound::markReachable(double needed, std::size_t x)
{
    if (x > open_.size()) return false;
    values_.clear();
    for (const Eigen::Index j : open_)
    {
        const double sigma = 1.0 - sums_[static_cast<std::size_t>(j)][x - 2];
        if (sigma <= 0.0)
        {
            std::fill(reachable_.begin(), reachable_.end(), char{1});
            return true;
        }
        values_.push_back(w_[static_cast<std::size_t>(j)] / sigma);
    }
    largest_.assign(x, 0.0);
    for (const double value : values_)
        if (value > largest_.back()) insert(largest_, value);
    const double last = largest_.back();
    const double others = std::accumulate(largest_.begin(), largest_.end() - 1, 0.0);
    for (std::size_t k = 0; k < values_.size(); ++k)
        if (others + std::min(values_[k], last) >= needed) reachable_[k] = 1;
    return others + last >= needed;
}

bool RemovalBound::keepForced(double d2, Eigen::Index removed, const SubsetIncumbent& incumbent)
{
    const auto most = static_cast<std::size_t>(incumbent.removals() - removed);
    for (;;)
    {
        if (open_.size() < 2) return false;
        couplings(most - 1);
        reachable_.assign(open_.size(), char{0});
        bool any = false;
        for (std::size_t x = 2; x <= most; ++x)
        {
            const double threshold = incumbent.threshold(removed + static_cast<Eigen::Index>(x));
            any = markReachable(d2 - threshold - kPruneMargin, x) || any;
        }
        if (!any) return false;
        std::size_t left = 0;
        for (std::size_t k = 0; k < open_.size(); ++k)
            if (reachable_[k]) open_[left++] = open_[k];
        if (left == open_.size()) return true;
        open_.resize(left);
    }
}
}  // namespace monoslam
