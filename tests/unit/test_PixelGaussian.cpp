// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/PixelGaussian.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <numeric>
#include <tuple>

#include "PerspectiveFrame.h"

namespace monoslam::test
{
namespace
{
Prediction perspectivePrediction(unsigned seed)
{
    const PerspectiveFrame frame({8, 7, false, 0.5, 0.0, 0}, seed);
    return frame.view().predict(frame.belief);
}

/** Mean and covariance of all pixels, conditioned by the textbook's dense formula. */
struct DenseGaussian
{
    Eigen::VectorXd mean;
    Eigen::MatrixXd P;

    DenseGaussian(const Prediction& prediction, Eigen::MatrixXd joint)
        : mean(2 * prediction.count()), P(std::move(joint))
    {
        for (Eigen::Index i = 0; i < prediction.count(); ++i)
            mean.segment<2>(2 * i) = prediction.rows[static_cast<std::size_t>(i)].h;
    }
    void condition(Eigen::Index row, const Eigen::Vector2d& z, const Eigen::Matrix2d& R)
    {
        const Eigen::Matrix2d S = P.block<2, 2>(2 * row, 2 * row) + R;
        const Eigen::MatrixXd K = P.middleCols<2>(2 * row) * S.inverse();
        mean += (K * (z - mean.segment<2>(2 * row))).eval();
        P -= (K * P.middleRows<2>(2 * row)).eval();
    }
};

void expectEqual(const PixelGaussian& fast, const DenseGaussian& slow, double tolerance)
{
    for (Eigen::Index i = 0; i < slow.mean.size() / 2; ++i)
    {
        EXPECT_LT((fast.mean(i) - slow.mean.segment<2>(2 * i)).norm(), tolerance) << i;
        const Eigen::Matrix2d P = slow.P.block<2, 2>(2 * i, 2 * i);
        EXPECT_LT(largestDifference(fast.covariance(i), P), tolerance * (1.0 + P.norm())) << i;
    }
}

Eigen::Matrix2d someNoise(double a)
{
    return (Eigen::Matrix2d() << 0.3, 0.05 * a, 0.05 * a, 0.2 + 0.1 * a).finished();
}

/** The joint covariance that a tree of exact neighbour pairs defines: its precision is the sum of
 *  the pairs' less the doubly counted nodes'. */
Eigen::MatrixXd treeCovariance(const Prediction& prediction,
                               const std::vector<Eigen::Index>& parents)
{
    const Eigen::Index m = prediction.count();
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(2 * m, 2 * m);
    for (Eigen::Index i = 0; i < m; ++i)
    {
        const Eigen::Index j = parents[static_cast<std::size_t>(i)];
        const Eigen::Matrix2d own = prediction.HPHt.block<2, 2>(2 * i, 2 * i);
        if (j < 0)
        {
            information.block<2, 2>(2 * i, 2 * i) += own.inverse();
            continue;
        }
        const Eigen::Matrix2d parent = prediction.HPHt.block<2, 2>(2 * j, 2 * j);
        const Eigen::Matrix2d B = prediction.HPHt.block<2, 2>(2 * i, 2 * j) * parent.inverse();
        const Eigen::Matrix2d Q = own - B * parent * B.transpose();
        Eigen::MatrixXd D = Eigen::MatrixXd::Zero(2, 2 * m);
        D.middleCols<2>(2 * i).setIdentity();
        D.middleCols<2>(2 * j) = -B;
        information += D.transpose() * Q.inverse() * D;
    }
    return information.inverse();
}
}  // namespace

TEST(DensePixels, EqualsDenseGaussianConditioning)
{
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
        const Prediction prediction = perspectivePrediction(seed);
        DenseGaussian slow(prediction, prediction.HPHt);
        const auto fast = densePixels(prediction);
        for (const Eigen::Index row : {4, 0, 9, 2, 7, 5, 1, 8, 3, 6})
        {
            const Eigen::Vector2d z = slow.mean.segment<2>(2 * row) + Eigen::Vector2d(0.7, -1.1);
            const auto before = fast->clone();
            fast->condition(row, z, someNoise(static_cast<double>(row % 3)));
            expectEqual(*before, slow, 1e-8);
            slow.condition(row, z, someNoise(static_cast<double>(row % 3)));
            expectEqual(*fast, slow, 1e-8);
        }
    }
}

TEST(TreePixels, EqualsDenseConditioningOfTheTreesOwnGaussian)
{
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
        const Prediction prediction = perspectivePrediction(seed);
        DenseGaussian slow(prediction, treeCovariance(prediction, chowLiuParents(prediction)));
        const auto fast = treePixels(prediction);
        expectEqual(*fast, slow, 1e-5);
        for (const Eigen::Index row : {4, 0, 9, 2})
        {
            const Eigen::Vector2d z = slow.mean.segment<2>(2 * row) + Eigen::Vector2d(0.7, -1.1);
            fast->condition(row, z, someNoise(1.0));
            slow.condition(row, z, someNoise(1.0));
            expectEqual(*fast, slow, 1e-5);
        }
    }
}

TEST(ChowLiuParents, SpanTheTreeOfMostInformation)
{
    // Kruskal on the literal determinants.
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
        const Prediction prediction = perspectivePrediction(seed);
        const Eigen::Index m = prediction.count();
        const auto bits = [&](Eigen::Index i, Eigen::Index j)
        {
            Eigen::Matrix4d S;
            const auto &a = prediction.rows[static_cast<std::size_t>(i)],
                       &b = prediction.rows[static_cast<std::size_t>(j)];
            S << a.S, prediction.HPHt.block<2, 2>(2 * i, 2 * j),
                prediction.HPHt.block<2, 2>(2 * j, 2 * i), b.S;
            return 0.5 * std::log2(a.S.determinant() * b.S.determinant() / S.determinant());
        };
        std::vector<std::tuple<double, Eigen::Index, Eigen::Index>> edges;
        for (Eigen::Index i = 0; i < m; ++i)
            for (Eigen::Index j = 0; j < i; ++j) edges.emplace_back(-bits(i, j), i, j);
        std::sort(edges.begin(), edges.end());
        std::vector<Eigen::Index> part(static_cast<std::size_t>(m));
        std::iota(part.begin(), part.end(), 0);
        double most = 0.0;
        for (const auto& [weight, i, j] : edges)
        {
            const Eigen::Index from = part[static_cast<std::size_t>(i)],
                               to = part[static_cast<std::size_t>(j)];
            if (from == to) continue;
            most -= weight;
            for (Eigen::Index& p : part)
                if (p == from) p = to;
        }
        double sum = 0.0;
        const auto parents = chowLiuParents(prediction);
        for (Eigen::Index i = 0; i < m; ++i)
            if (parents[static_cast<std::size_t>(i)] >= 0)
                sum += bits(i, parents[static_cast<std::size_t>(i)]);
        EXPECT_EQ(std::count(parents.begin(), parents.end(), -1), 1);
        EXPECT_NEAR(sum, most, 1e-6 * most);
    }
}
}  // namespace monoslam::test
