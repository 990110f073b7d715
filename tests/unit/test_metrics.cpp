// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/metrics.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <filesystem>
#include <fstream>

#include "monoslam_eval/consistency.h"
#include "monoslam_models/quaternion.h"
#include "randomValues.h"

namespace monoslam
{
namespace
{
Trajectory winding(int count)
{
    Trajectory trajectory;
    for (int i = 0; i < count; ++i)
    {
        const double a = i / 20.0;
        trajectory.push_back({i / 30.0,
                              {std::sin(a), std::cos(1.7 * a), 0.3 * a},
                              quaternionExp({0.2 * std::sin(a), 0.1 * a, 0.3 * std::cos(a)})});
    }
    return trajectory;
}

Trajectory moved(Trajectory trajectory, const Similarity& similarity)
{
    for (StampedPose& pose : trajectory) pose = transform(similarity, pose);
    return trajectory;
}

Similarity someSimilarity()
{
    return {0.7, rotationMatrix(quaternionExp({0.4, -1.1, 0.6})), {3.0, -1.0, 0.5}};
}

TEST(Metrics, Sim3FindsTheSimilarityThatWasApplied)
{
    const Trajectory truth = winding(100);
    const auto pairs = matchByTime(moved(truth, someSimilarity()), truth);
    const TrajectoryErrors sim3 = trajectoryErrors(pairs, Alignment::Sim3);
    EXPECT_NEAR(sim3.alignment.s, 1.0 / 0.7, 1e-12);
    EXPECT_LT((sim3.alignment.R - someSimilarity().R.transpose()).norm(), 1e-12);
    EXPECT_LT(sim3.position_m.max, 1e-12);
    EXPECT_LT(sim3.rotation_rad.max, 1e-7);
    EXPECT_LT(sim3.secondPosition_m.max, 1e-12);
    EXPECT_EQ(sim3.stepPosition_m.count, 99);
    EXPECT_EQ(sim3.secondPosition_m.count, 70);
}

TEST(Metrics, Se3KeepsTheScaleAndSoTheErrorOfAWrongOne)
{
    const Trajectory truth = winding(100);
    const auto pairs = matchByTime(moved(truth, someSimilarity()), truth);
    const TrajectoryErrors se3 = trajectoryErrors(pairs, Alignment::SE3);
    EXPECT_EQ(se3.alignment.s, 1.0);
    EXPECT_NEAR(se3.position_m.rmse, 0.3 * standingStillError(pairs), 1e-12);
}

TEST(Metrics, MirroredPathIsNotAlignedByAReflection)
{
    Trajectory truth = winding(100), mirrored = truth;
    for (StampedPose& pose : mirrored) pose.r_wc.x() *= -1.0;
    const Similarity fit = align(matchByTime(mirrored, truth), Alignment::Sim3);
    EXPECT_NEAR(fit.R.determinant(), 1.0, 1e-12);
}

TEST(Metrics, RotationErrorIsTheAngleThatWasAdded)
{
    const Trajectory truth = winding(100);
    Trajectory turned = truth;
    for (StampedPose& pose : turned)
        pose.q_wc = quaternionProduct(pose.q_wc, quaternionExp({0.0, 0.02, 0.0}));
    const auto pairs = matchByTime(turned, truth);
    EXPECT_NEAR(trajectoryErrors(pairs, Alignment::SE3).rotation_rad.rmse, 0.02, 1e-9);
    EXPECT_LT(rotationErrors(pairs).rmse, 0.02);
}

TEST(Metrics, ScaleDriftIsTheGrowthOfTheEstimate)
{
    const Trajectory truth = winding(300);
    Trajectory grown = truth;
    for (std::size_t i = 150; i < grown.size(); ++i)
        grown[i].r_wc = truth[150].r_wc + 1.1 * (truth[i].r_wc - truth[150].r_wc);
    const ScaleDrift drift = scaleDrift(matchByTime(grown, truth));
    EXPECT_NEAR(drift.drift, 0.1, 1e-12);
    EXPECT_TRUE(drift.reliable);
}

TEST(Metrics, TruthIsInterpolatedAtTheTimeOfTheEstimate)
{
    Trajectory truth{{0.0, {0, 0, 0}, quaternionExp({0, 0, 0})},
                     {0.02, {1, 0, 0}, -quaternionExp({0.4, 0, 0})},
                     {0.50, {2, 0, 0}, quaternionExp({0.4, 0, 0})}};
    const Trajectory estimate{{0.005, {}}, {0.3, {}}, {0.485, {}}};
    const auto pairs = matchByTime(estimate, truth);
    ASSERT_EQ(pairs.size(), 2U);
    EXPECT_NEAR(pairs[0].truth.r_wc.x(), 0.25, 1e-12);
    EXPECT_NEAR(quaternionLog(pairs[0].truth.q_wc).x(), 0.1, 1e-12);
    EXPECT_EQ(pairs[1].index, 2U);
    EXPECT_EQ(pairs[1].truth.r_wc.x(), 2.0);  // too far from 0.02 to interpolate
    EXPECT_EQ(matchByTime(estimate, truth, {0.02, false})[0].truth.r_wc.x(), 0.0);
}

TEST(Metrics, OutAndBackMeasuresGapLineAndLengths)
{
    Trajectory path;
    for (int i = 0; i <= 100; ++i) path.push_back({0.1 * i, {0.01 * i, 0.0, 2.0}});
    for (int i = 99; i >= 10; --i) path.push_back({0.1 * (200 - i), {0.01 * i, 0.0, 2.0}});
    const OutAndBack o = outAndBack(path);
    EXPECT_NEAR(o.outLength, 1.0, 1e-12);
    EXPECT_NEAR(o.backLength, 0.9, 1e-12);
    EXPECT_NEAR(o.gap, 0.1, 1e-12);
    EXPECT_LT(o.offLine, 1e-12);
}

TEST(Metrics, ReadTumNamesTheLineThatIsWrong)
{
    const auto file = std::filesystem::temp_directory_path() / "monoslam_test_metrics.tum";
    const auto reason = [&file](const std::string& content)
    {
        std::ofstream(file) << content;
        try
        {
            (void)readTum(file.string());
        }
        catch (const std::invalid_argument& e)
        {
            return std::string(e.what());
        }
        return std::string();
    };
    EXPECT_EQ(reason("# t x y z q\n1 0 0 0 0 0 0 1\n\n2 0 0 0 0 0 0 1\n"), "");
    EXPECT_NE(reason("1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n").find(":2: time"), std::string::npos);
    EXPECT_NE(reason("1 0 0 0 0 0 0 2\n").find(":1: not"), std::string::npos);
    EXPECT_NE(reason("1 0 0 nan 0 0 0 1\n").find(":1: not"), std::string::npos);
    EXPECT_NE(reason("1 0 0 0 0 0 0 1 9\n").find(":1: not"), std::string::npos);
    std::filesystem::remove(file);
    EXPECT_THROW((void)readTum(file.string()), std::invalid_argument);
}

TEST(Nees, HasTheExpectationAndBoundsOfSixNumbers)
{
    std::mt19937 rng(5);
    const Matrix6d A = Matrix6d::Identity() + 0.1 * Matrix6d::Ones();
    double mean = 0.0;
    const int draws = 20000;
    for (int i = 0; i < draws; ++i)
        mean += *nees(A * normalVector<6>(rng, 1e-3), 1e-6 * A * A.transpose()) / draws;
    EXPECT_NEAR(mean, 6.0, 0.1);
    EXPECT_FALSE(nees(Vector6d::Ones(), Matrix6d::Zero()));
    const Interval bounds = chi2MeanBounds(6, 50, 0.95);
    EXPECT_NEAR(bounds.low, 5.0783, 1e-3);
    EXPECT_NEAR(bounds.high, 6.9975, 1e-3);
}

TEST(Nees, VanishesWhenTheAlignedPosesAreRight)
{
    const Trajectory truth = winding(50);
    const auto pairs = matchByTime(moved(truth, someSimilarity()), truth);
    std::vector<StampedCovariance> P;
    for (const StampedPose& pose : truth) P.push_back({pose.t_s, Matrix6d::Identity()});
    const auto values = trajectoryNees(pairs, P, alignFirstPose(pairs));
    ASSERT_EQ(values.size(), 50U);
    for (const auto& value : values)
    {
        ASSERT_TRUE(value);
        EXPECT_LT(*value, 1e-12);
    }
    P.erase(P.begin() + 20);
    const auto withGap = trajectoryNees(pairs, P, alignFirstPose(pairs));
    ASSERT_EQ(withGap.size(), 50U);
    EXPECT_FALSE(withGap[20]);
    EXPECT_TRUE(withGap[21]);
}
}  // namespace
}  // namespace monoslam
