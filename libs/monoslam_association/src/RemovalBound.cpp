// SPDX-License-Identifier: BSD-3-Clause
#include "RemovalBound.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "subsetSearches.h"

namespace monoslam
{
namespace
{
/** Where the blocks of a pair with the later ones begin, component by component. */
struct BlockColumns
{
    const double *c00, *c10, *c01, *c11;
};

/** N_lj = sqrt(f + sqrt(f^2 - det^2)), 2 f the sum of squares of C_lj, for kWidth pairs l. */
template <int kWidth>
void couplings(const BlockColumns& Lam, const Eigen::ArrayX3d& G_inverse, Eigen::Index l,
               const Eigen::Array3d& own, double* N)
{
    using Pack = Eigen::Array<double, kWidth, 1>;
    using Load = Eigen::Map<const Pack>;
    const Pack g00 = G_inverse.col(0).segment<kWidth>(l);
    const Pack g10 = G_inverse.col(1).segment<kWidth>(l);
    const Pack g11 = G_inverse.col(2).segment<kWidth>(l);
    const Pack left0 = own(0) * Load(Lam.c00), left1 = own(0) * Load(Lam.c10);
    const Pack right0 = own(1) * Load(Lam.c00) + own(2) * Load(Lam.c01);
    const Pack right1 = own(1) * Load(Lam.c10) + own(2) * Load(Lam.c11);
    const Pack c00 = g00 * left0, c01 = g00 * right0;
    const Pack c10 = g10 * left0 + g11 * left1, c11 = g10 * right0 + g11 * right1;
    const Pack det = c00 * c11 - c01 * c10;
    const Pack f = 0.5 * (c00.square() + c01.square() + c10.square() + c11.square());
    Eigen::Map<Pack> result(N);
    result = (f + (f.square() - det.square()).max(0.0).sqrt()).sqrt();
}
}  // namespace

void RemovalBound::measure(const PairMatrix& Lam, const PairVector& gt)
{
    const Eigen::Index n = n_ = Lam.size();
    if (N_.rows() < n)
    {
        N_.resize(n, n);
        G_inverse_.resize(n, 3);
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

/** Of all l > j; those before are there. */
void RemovalBound::coupleWithLater(const PairMatrix& Lam, Eigen::Index j)
{
    const Eigen::Index n = Lam.size();
    const Eigen::Array3d own = G_inverse_.row(j).transpose();
    const auto at = [&](Eigen::Index l)
    {
        return BlockColumns{Lam.address(0, 0, l, j), Lam.address(1, 0, l, j),
                            Lam.address(0, 1, l, j), Lam.address(1, 1, l, j)};
    };
    Eigen::Index l = j + 1;
    for (; l + 4 <= n; l += 4) couplings<4>(at(l), G_inverse_, l, own, &N_(l, j));
    for (; l < n; ++l) couplings<1>(at(l), G_inverse_, l, own, &N_(l, j));
    N_(j, j) = 0.0;
    N_.row(j).segment(j + 1, n - j - 1) = N_.col(j).segment(j + 1, n - j - 1).transpose();
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
    setSums(j, [this](Eigen::Index x) { return largest_[static_cast<std::size_t>(x)]; });
}

/** The same of kTogether columns from j on, without a branch for each number. */
void RemovalBound::sumLargestTogether(Eigen::Index j)
{
    using Pack = Eigen::Array<double, kTogether, 1>;
    largestTogether_.assign(static_cast<std::size_t>(summed_), Pack::Zero());
    for (const Eigen::Index l : strongest_)
    {
        Pack value = N_.col(l).segment<kTogether>(j);  // symmetric; 0 where l is the column itself
        if ((value <= largestTogether_.back()).all()) continue;
        for (Pack& largest : largestTogether_)
        {
            const Pack less = largest.min(value);
            largest = largest.max(value);
            value = less;
        }
    }
    for (Eigen::Index k = 0; k < kTogether; ++k)
        setSums(j + k,
                [&](Eigen::Index x) { return largestTogether_[static_cast<std::size_t>(x)](k); });
}

template <class Largest>
void RemovalBound::setSums(Eigen::Index j, const Largest& largest)
{
    double sum = 0.0;
    for (Eigen::Index x = 0; x < summed_; ++x) sums_(x, j) = sum += largest(x);
    least_(j) = largest(summed_ - 1);
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
        for (Eigen::Index j = 0; j + kTogether <= n_; j += kTogether) sumLargestTogether(j);
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
