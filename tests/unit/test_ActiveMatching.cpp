// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <numeric>

#include "PerspectiveFrame.h"
#include "associatorRuns.h"
#include "monoslam_association/PixelGaussian.h"
#include "monoslam_association/chooseSubset.h"
#include "monoslam_association/ellipseMass.h"
#include "monoslam_association/informationGain.h"

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

TEST(EllipseMass, EqualsASumOverAFineGrid)
{
    std::mt19937 rng(1);
    for (int i = 0; i < 40; ++i)
    {
        const Eigen::Matrix2d A = uniformVector<4>(rng, 3.0).reshaped(2, 2),
                              B = uniformVector<4>(rng, 3.0).reshaped(2, 2);
        const Eigen::Matrix2d C = A * A.transpose() + 0.2 * Eigen::Matrix2d::Identity();
        const Eigen::Matrix2d S = B * B.transpose() + 0.2 * Eigen::Matrix2d::Identity();
        const Eigen::Vector2d mean = uniformVector<2>(rng, 5.0);
        const double gate = 5.9915;
        const Eigen::Matrix2d precision = C.inverse(), region = S.inverse();
        const double step = 0.02;
        double sum = 0.0;
        const double u_px = std::sqrt(gate * S(0, 0)), v_px = std::sqrt(gate * S(1, 1));
        for (double u = -u_px; u <= u_px; u += step)
            for (double v = -v_px; v <= v_px; v += step)
            {
                const Eigen::Vector2d y(u, v);
                if (y.dot(region * y) >= gate) continue;
                sum += std::exp(-0.5 * (y - mean).dot(precision * (y - mean)));
            }
        sum *= step * step / (2.0 * M_PI * std::sqrt(C.determinant()));
        EXPECT_NEAR(ellipseMass(mean, C, S, gate), sum, 3e-3) << i;
    }
    const Eigen::Matrix2d I = Eigen::Matrix2d::Identity();
    EXPECT_NEAR(ellipseMass({0.0, 0.0}, I, I, 5.991465), 0.95, 1e-4);
    EXPECT_EQ(ellipseMass({50.0, 0.0}, I, I, 5.9915), 0.0);
    EXPECT_NEAR(ellipseMass({0.0, 0.0}, 1e-6 * I, I, 5.9915), 1.0, 1e-4);
}

TEST(ChooseSubset, AddsTheLandmarkOfMostInformationGivenThoseBefore)
{
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
        const PerspectiveFrame frame({8, 7, false, 0.5, 0.0, 0}, seed);
        Belief belief = frame.belief;
        const Prediction prediction = frame.view().predict(belief);
        std::vector<Eigen::Index> rows(static_cast<std::size_t>(prediction.count()));
        std::iota(rows.begin(), rows.end(), 0);
        const auto fast = chooseSubset(belief, prediction, rows, 5);
        // The slow form: H fixed, P conditioned in full.
        Eigen::MatrixXd H = Eigen::MatrixXd::Zero(2 * prediction.count(), belief.size());
        for (const Eigen::Index i : rows)
        {
            const PredictedLandmark& row = prediction.rows[static_cast<std::size_t>(i)];
            H.block<2, 13>(2 * i, 0) = row.H_v;
            H.block(2 * i, row.offset, 2, row.size) = row.H_y.leftCols(row.size);
        }
        std::vector<Eigen::Index> slow;
        while (slow.size() < 5)
        {
            const PoseInformation information(belief.pose(), belief.P.topLeftCorner<7, 7>());
            Eigen::Index best = -1;
            double most = -1.0;
            for (const Eigen::Index i : rows)
            {
                if (std::find(slow.begin(), slow.end(), i) != slow.end()) continue;
                const Eigen::MatrixXd PHt = belief.P * H.middleRows<2>(2 * i).transpose();
                const Eigen::Matrix2d S =
                    H.middleRows<2>(2 * i) * PHt + prediction.rows[static_cast<std::size_t>(i)].R;
                const double bits = information(PHt.topRows<7>(), S);
                if (bits > most) most = bits, best = i;
            }
            slow.push_back(best);
            const Eigen::MatrixXd PHt = belief.P * H.middleRows<2>(2 * best).transpose();
            const Eigen::Matrix2d S =
                H.middleRows<2>(2 * best) * PHt + prediction.rows[static_cast<std::size_t>(best)].R;
            belief.P -= PHt * S.inverse() * PHt.transpose();
        }
        EXPECT_EQ(fast, slow) << seed;
    }
}

class ActivelyMatching : public testing::TestWithParam<const char*>
{
};

TEST_P(ActivelyMatching, TakesTheConsistentCandidateAmongClutter)
{
    int right = 0, wrong = 0, seen = 0;
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
        const PerspectiveFrame frame({12, 12, false, 0.5, 0.0, 3}, seed);
        const Correction correction = run(GetParam(), frame);
        for (const Association& record : correction.associations)
        {
            ++seen;
            if (record.fate != Fate::Matched) continue;
            const bool isRight = record.z == frame.seen.at(record.id).front().z;
            right += isRight ? 1 : 0;
            wrong += isRight ? 0 : 1;
        }
    }
    EXPECT_GT(right, seen * 85 / 100);
    EXPECT_LT(wrong, seen * 4 / 100);
}

TEST_P(ActivelyMatching, RejectsWhatTheOthersContradict)
{
    LinearWorld world = LinearWorld::withLandmarks(30, 10);
    for (const LandmarkId id : {2, 9, 17, 28}) world.displace(id, {-9.0, 10.0});
    const Correction correction = run(GetParam(), world);
    for (const LandmarkId id : {2, 9, 17, 28})
        EXPECT_NE(recordOf(correction, id).fate, Fate::Matched) << id;
    EXPECT_GE(count(correction, Fate::Matched), 23);
}

INSTANTIATE_TEST_SUITE_P(All, ActivelyMatching,
                         testing::Values("active_matching", "clam", "subam"));

TEST(ActiveMatching, TakesBackAnEarlyMatchThatLaterOnesContradict)
{
    // The first landmark measured has a wrong pixel only; a single hypothesis would follow it.
    int recovered = 0, fooled = 0;
    for (unsigned seed = 1; seed <= 30; ++seed)
    {
        LinearWorld world = LinearWorld::withLandmarks(12, seed);
        for (const LandmarkId id : {0, 1, 2}) world.displace(id, {10.0, -8.0});
        const auto isGood = [&](const char* name)
        {
            const Correction c = run(name, world);
            long good = 0;
            for (const Association& record : c.associations)
                good += record.fate == Fate::Matched && record.id > 2 ? 1 : 0;
            return good >= 7;
        };
        recovered += isGood("active_matching") ? 1 : 0;
        fooled += isGood("active_search") ? 0 : 1;
    }
    EXPECT_GE(recovered, 27);
    EXPECT_GT(fooled, 30 - recovered);
}
}  // namespace monoslam::test
