// SPDX-License-Identifier: BSD-3-Clause
// What MRPT 2.5.8 answers and what we do: each test is one row of the table in libs/docs/mrpt.md.
#include <gtest/gtest.h>
#include <mrpt/slam/data_association.h>

#include "monoslam_mrpt/RangeBearingKFSLAM.h"
#include "monoslam_mrpt/dataAssociationFullCovariance.h"
#include "rangeBearingWorld.h"

namespace monoslam::test
{
namespace
{
using mrpt::math::CMatrixDouble;
using mrpt::slam::TDataAssociationResults;
using Pairs = std::map<std::size_t, std::size_t>;

struct Answers
{
    TDataAssociationResults mrpt, ours;
};

struct Case
{
    CMatrixDouble Z, Y, S;
    bool kdTree = false;
};

Answers ask(const Case& c, mrpt::slam::TDataAssociationMethod method = mrpt::slam::assocJCBB)
{
    Answers answers;
    mrpt::slam::data_association_full_covariance(c.Z, c.Y, c.S, answers.mrpt, method, metricMaha,
                                                 0.99, c.kdTree);
    dataAssociationFullCovariance(c.Z, c.Y, c.S, answers.ours, method, metricMaha, 0.99, c.kdTree);
    return answers;
}

CMatrixDouble points(const std::vector<Eigen::Vector2d>& all)
{
    CMatrixDouble matrix(static_cast<Eigen::Index>(all.size()), 2);
    for (std::size_t i = 0; i < all.size(); ++i)
        matrix.asEigen().row(static_cast<Eigen::Index>(i)) = all[i].transpose();
    return matrix;
}

/** I + common variance of all x, and of all y. */
CMatrixDouble sharedCovariance(Eigen::Index n, double common)
{
    CMatrixDouble S(2 * n, 2 * n);
    for (Eigen::Index i = 0; i < 2 * n; ++i)
        for (Eigen::Index j = 0; j < 2 * n; ++j)
            S(i, j) = (i == j ? 1.0 : 0.0) + (i % 2 == j % 2 ? common : 0.0);
    return S;
}
}  // namespace

TEST(MrptFaults, NoJointTest)
{
    // A common error of 5 cannot move one point by 8 to the right and the other to the left.
    const Case c{points({{8, 0}, {92, 0}}), points({{0, 0}, {100, 0}}), sharedCovariance(2, 25.0)};
    const Answers answers = ask(c);
    EXPECT_EQ(answers.mrpt.associations, (Pairs{{0, 0}, {1, 1}}));
    EXPECT_NEAR(answers.mrpt.distance, 128.0, 1e-9);
    EXPECT_EQ(answers.ours.associations.size(), 1U);
    EXPECT_LT(answers.ours.distance, 13.28);
}

TEST(MrptFaults, BoundIsOffByOne)
{
    // The first observation is at the second prediction, the second at the first.
    const Case c{points({{2, 0}, {0, 0}}), points({{0, 0}, {2, 0}}), sharedCovariance(2, 0.0)};
    const Answers answers = ask(c);
    EXPECT_EQ(answers.mrpt.associations, (Pairs{{0, 0}, {1, 1}}));
    EXPECT_GT(answers.mrpt.distance, 7.9);
    EXPECT_EQ(answers.ours.associations, (Pairs{{0, 1}, {1, 0}}));
    EXPECT_NEAR(answers.ours.distance, 0.0, 1e-12);
}

TEST(MrptFaults, BoundCountsCandidatesInsteadOfObservations)
{
    // Each observation is compatible with the three predictions of its group.
    std::vector<Eigen::Vector2d> predictions, observations;
    for (const double group : {0.0, 100.0, 200.0})
        for (const double member : {0.0, 1.0, 2.0})
        {
            predictions.emplace_back(group + member, 0.0);
            observations.emplace_back(group + member + 0.1, 0.0);
        }
    const Case c{points(observations), points(predictions), sharedCovariance(9, 0.0)};
    const Answers answers = ask(c);
    EXPECT_GT(answers.mrpt.nNodesExploredInJCBB, 1000U);
    EXPECT_LT(answers.ours.nNodesExploredInJCBB, 20U);
    EXPECT_EQ(answers.ours.associations.size(), 9U);
    EXPECT_NEAR(answers.ours.distance, 0.09, 1e-9);
}

TEST(MrptFaults, KdTreeLosesCompatiblePairs)
{
    // The nearest prediction is the most certain one and far away for it; the search stops there.
    Case c{points({{10, 0}}), points({{5, 0}, {0, 0}}), sharedCovariance(2, 0.0), true};
    c.S(0, 0) = c.S(1, 1) = 0.01;
    c.S(2, 2) = c.S(3, 3) = 100.0;
    const Answers withTree = ask(c);
    c.kdTree = false;
    const Answers without = ask(c);
    EXPECT_EQ(withTree.mrpt.associations, Pairs{});
    EXPECT_EQ(without.mrpt.associations, (Pairs{{0, 1}}));
    EXPECT_EQ(withTree.ours.associations, (Pairs{{0, 1}}));
    EXPECT_EQ(without.ours.associations, (Pairs{{0, 1}}));
}

TEST(MrptFaults, QuantilesAreApproximate)
{
    // chi2(1, 0.95) = 3.8415: a pair at 3.8 passes.
    Case c{CMatrixDouble(1, 1), CMatrixDouble(1, 1), CMatrixDouble(1, 1)};
    c.Z(0, 0) = std::sqrt(3.8);
    c.S(0, 0) = 1.0;
    TDataAssociationResults theirs, ours;
    mrpt::slam::data_association_full_covariance(c.Z, c.Y, c.S, theirs, mrpt::slam::assocNN,
                                                 metricMaha, 0.95, false);
    dataAssociationFullCovariance(c.Z, c.Y, c.S, ours, assocNN, metricMaha, 0.95);
    EXPECT_EQ(theirs.associations, Pairs{});
    EXPECT_EQ(ours.associations, (Pairs{{0, 0}}));
}

TEST(MrptFaults, NearestNeighboursHaveNoDistance)
{
    const Case c{points({{1, 0}}), points({{0, 0}}), sharedCovariance(1, 0.0)};
    const Answers answers = ask(c, mrpt::slam::assocNN);
    EXPECT_EQ(answers.mrpt.associations, answers.ours.associations);
    EXPECT_EQ(answers.mrpt.distance, std::numeric_limits<double>::max());
    EXPECT_NEAR(answers.ours.distance, 1.0, 1e-12);
}

TEST(MrptFaults, LikelihoodIsNormalisedForOnePair)
{
    const Case c{points({{0, 0}, {100, 0}}), points({{0, 0}, {100, 0}}), sharedCovariance(2, 0.0)};
    TDataAssociationResults theirs, ours;
    mrpt::slam::data_association_full_covariance(c.Z, c.Y, c.S, theirs, mrpt::slam::assocJCBB,
                                                 mrpt::slam::metricML, 0.99, false);
    dataAssociationFullCovariance(c.Z, c.Y, c.S, ours, assocJCBB, metricML);
    const double twoPi = 2.0 * std::acos(-1.0);
    EXPECT_NEAR(theirs.distance, 1.0 / twoPi, 1e-12);
    EXPECT_NEAR(ours.distance, 1.0 / (twoPi * twoPi), 1e-12);
}

TEST(MrptFaults, AnglesAreNotWrappedInInnovations)
{
    // A landmark behind the robot, predicted at +179.9 and seen at -179.9 degrees.
    RangeBearingWorld world({{-10.0, 0.0, 0.0}});
    mrpt::slam::CRangeBearingKFSLAM2D theirs;
    RangeBearingKFSLAM2D ours;
    for (auto* slam : {&theirs, static_cast<mrpt::slam::CRangeBearingKFSLAM2D*>(&ours)})
    {
        slam->options.std_sensor_range = 0.05F;
        slam->options.std_sensor_yaw = 0.01F;
        world.turnTo(0.0017);
        world.step(*slam);
        world.turnTo(-0.0017);
        world.step(*slam);
    }
    EXPECT_EQ(theirs.getNumberOfLandmarksInTheMap(), 2U);
    EXPECT_EQ(ours.getNumberOfLandmarksInTheMap(), 1U);
}

TEST(MrptFaults, CovarianceBecomesAsymmetric)
{
    RangeBearingWorld world({{5.0, 1.0, 0.5}, {6.0, -2.0, -0.5}, {8.0, 0.5, 1.0}});
    mrpt::slam::CRangeBearingKFSLAM theirs;
    RangeBearingKFSLAM ours;
    for (int step = 0; step < 50; ++step)
    {
        world.move(0.05);
        world.step(theirs);
        world.step(ours);
    }
    EXPECT_GT(asymmetry(theirs), 0.0);
    EXPECT_EQ(asymmetry(ours), 0.0);
}
}  // namespace monoslam::test
