// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "monoslam_association/jointBranchAndBound.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_association/largestCompatibleSubset.h"

namespace monoslam::test
{
inline Eigen::MatrixXd gaussian(Eigen::Index rows, Eigen::Index columns, std::mt19937& rng)
{
    std::normal_distribution<double> normal;
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(rng); });
}

/** Limits chi2(2 (m - i), 0.95) for i = 0 .. m. */
inline std::vector<double> limitsFor(Eigen::Index m, const Chi2Table& table)
{
    std::vector<double> limits;
    for (Eigen::Index kept = m; kept >= 0; --kept) limits.push_back(table(2 * kept));
    return limits;
}

/** m pairs that share a six-dimensional pose error of many pixels, r of them off by up to 3 sigma
 *  of their own S, the others drawn from S. */
inline SubsetProblem randomProblem(Eigen::Index m, Eigen::Index r, const Chi2Table& table,
                                   std::mt19937& rng)
{
    const Eigen::MatrixXd J = 4.0 * gaussian(2 * m, 6, rng);
    const Eigen::MatrixXd depth = gaussian(2 * m, 1, rng);
    SubsetProblem problem;
    problem.S = J * J.transpose() + Eigen::MatrixXd(depth.cwiseAbs2().asDiagonal());
    problem.S.diagonal().array() += 1.0;
    problem.nu = problem.S.llt().matrixL() * Eigen::VectorXd(gaussian(2 * m, 1, rng));
    std::uniform_real_distribution<double> uniform(-2.4, 2.4);
    for (Eigen::Index i = 0; i < 2 * r; ++i)
        problem.nu(i) = uniform(rng) * std::sqrt(problem.S(i, i));
    problem.limits = limitsFor(m, table);
    return problem;
}

inline double denseD2(const SubsetProblem& problem, unsigned kept)
{
    std::vector<Eigen::Index> index;
    for (Eigen::Index i = 0; i < problem.nu.size(); ++i)
        if (kept >> (i / 2) & 1U) index.push_back(i);
    const auto k = static_cast<Eigen::Index>(index.size());
    const auto at = [&index](Eigen::Index i) { return index[static_cast<std::size_t>(i)]; };
    const Eigen::MatrixXd S = Eigen::MatrixXd::NullaryExpr(
        k, k, [&](Eigen::Index i, Eigen::Index j) { return problem.S(at(i), at(j)); });
    const Eigen::VectorXd nu =
        Eigen::VectorXd::NullaryExpr(k, [&](Eigen::Index i) { return problem.nu(at(i)); });
    return k == 0 ? 0.0 : nu.dot(S.llt().solve(nu));
}

/** The definition: every subset of every size, largest first. */
inline SubsetResult bruteForce(const SubsetProblem& problem)
{
    const auto m = static_cast<unsigned>(problem.pairs());
    for (unsigned removals = 0; removals <= m; ++removals)
    {
        unsigned best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (unsigned kept = 0; kept < 1U << m; ++kept)
        {
            if (static_cast<unsigned>(__builtin_popcount(kept)) != m - removals) continue;
            const double d2 = denseD2(problem, kept);
            if (d2 >= least) continue;
            least = d2;
            best = kept;
        }
        if (least > problem.limits[removals]) continue;
        SubsetResult result;
        result.d2 = least;
        for (unsigned j = 0; j < m; ++j)
            if (!(best >> j & 1U)) result.removed.push_back(static_cast<Eigen::Index>(j));
        return result;
    }
    return {};
}

/** The example of algorithms 6.7: pair 3 is wrong. */
inline SubsetProblem goldenProblem(const Chi2Table& table)
{
    SubsetProblem problem;
    const Eigen::MatrixXd A =
        Eigen::MatrixXd::NullaryExpr(10, 3,
                                     [](Eigen::Index i, Eigen::Index j)
                                     { return static_cast<double>((3 * i + 5 * j) % 7 - 3); });
    problem.S = A * A.transpose() + 4.0 * Eigen::MatrixXd::Identity(10, 10);
    problem.nu.resize(10);
    problem.nu << 1, -0.5, 2, 1, -1.5, 0.5, 9, -7, 0.5, 1;
    problem.limits = limitsFor(5, table);
    return problem;
}

/** The second example, hohct-fast 6: pairs 2 and 6 are wrong. */
inline SubsetProblem secondGoldenProblem(const Chi2Table& table)
{
    SubsetProblem problem;
    const Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(
        16, 4,
        [](Eigen::Index i, Eigen::Index j)
        { return static_cast<double>((5 * i + 3 * j + i * j) % 11 - 5); });
    problem.S = B * B.transpose() + Eigen::MatrixXd::Identity(16, 16);
    problem.nu = B * Eigen::Vector4d(0.8, -0.5, 0.3, 0.6);
    for (Eigen::Index i = 0; i < 16; ++i) problem.nu(i) += 0.5 * static_cast<double>(7 * i % 5 - 2);
    problem.nu(4) += 6;
    problem.nu(5) -= 4;
    problem.nu(12) -= 5;
    problem.nu(13) -= 5;
    problem.limits = limitsFor(8, table);
    return problem;
}
inline double binomial(Eigen::Index n, std::size_t k)
{
    double value = 1.0;
    for (std::size_t i = 1; i <= k; ++i)
        value *= static_cast<double>(n - static_cast<Eigen::Index>(i) + 1) / static_cast<double>(i);
    return std::round(value);
}

inline JcbbProblem jcbbProblem(const SubsetProblem& subset)
{
    JcbbProblem problem{&subset.S, {}, {}};
    for (Eigen::Index j = 0; j < subset.pairs(); ++j)
        problem.pairs.push_back({JointPair{j, subset.nu.segment<2>(2 * j)}});
    return problem;
}

inline std::size_t pairsOf(const JcbbResult& result)
{
    std::size_t pairs = 0;
    for (const int c : result.chosen) pairs += c >= 0 ? 1 : 0;
    return pairs;
}
}  // namespace monoslam::test
