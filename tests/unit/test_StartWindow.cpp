// SPDX-License-Identifier: BSD-3-Clause
#include "StartWindow.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "monoslam_eval/consistency.h"
#include "simulatedStart.h"

namespace monoslam
{
namespace
{
/** How much larger the estimated world is than the true one: without a target any size will do. */
double scaleOf(const Belief& belief, int frame)
{
    return belief.x.head<3>().norm() / SimulatedStart::truePose(frame).head<3>().norm();
}

/** Largest error of a landmark relative to its true distance, in a world of scale s. */
double worstLandmark(const SimulatedStart& start, const Belief& belief, double s)
{
    double worst = 0.0;
    for (const auto& slot : belief.landmarks)
    {
        const Eigen::Vector3d p_w = slot.kind == LandmarkKind::Point
                                        ? Eigen::Vector3d(belief.x.segment<3>(slot.offset))
                                        : toPoint(belief.x.segment<6>(slot.offset));
        const Eigen::Vector3d& truth = start.point(slot.id);
        worst = std::max(worst, (p_w / s - truth).norm() / truth.norm());
    }
    return worst;
}

StampedPose stamped(const Eigen::Vector3d& r, const Eigen::Vector4d& q)
{
    return {0.0, r, q};
}

/** Error of the pose in a world of scale s. */
Vector6d errorOf(const Belief& belief, int frame, double s)
{
    const Vector7d truth = SimulatedStart::truePose(frame);
    return poseError(stamped(belief.x.head<3>(), belief.x.segment<4>(3)),
                     stamped(s * truth.head<3>(), truth.tail<4>()));
}
}  // namespace

TEST(StartWindow, SetsAMirroredStartRight)
{
    SimulatedStartOptions options;
    options.guess = Guess::Mirrored;
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
        SimulatedStart start(options, seed);
        const auto refined = start.run();
        ASSERT_TRUE(refined) << seed;
        refined->belief.checkInvariant();
        EXPECT_GT(start.window().lastInlierRatio(), 0.98);
        EXPECT_EQ(refined->belief.landmarks.size(), SimulatedStart::kLandmarks);
        const double s = scaleOf(refined->belief, start.frame());
        const Vector6d e = errorOf(refined->belief, start.frame(), s);
        EXPECT_GT(refined->belief.x(0), 0.0);  // the guess went to the left
        EXPECT_LT(e.head<3>().norm(), 0.03 * refined->belief.x.head<3>().norm()) << seed;
        const auto squaredSigmas =
            nees(e, poseErrorCovariance(refined->belief.pose(), refined->belief.P));
        ASSERT_TRUE(squaredSigmas);
        EXPECT_LT(*squaredSigmas, 27.9) << seed;  // chi2(6, 0.9999)
        EXPECT_LT(worstLandmark(start, refined->belief, s), 0.1) << seed;
    }
}

/** With small parallax a wrong structure may explain as many pixels as are asked for. */
TEST(StartWindow, ComparesWithOtherStructuresEvenIfTheGuessExplainsThePixels)
{
    SimulatedStartOptions options;
    options.guess = Guess::Mirrored;
    options.start.good_inlier_ratio = 0.0;
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
        SimulatedStart start(options, seed);
        const auto refined = start.run();
        ASSERT_TRUE(refined) << seed;
        EXPECT_GT(refined->belief.x(0), 0.0) << seed;  // the guess went to the left
    }
}

/** A structure that explains its pixels much worse than an earlier one did is compared, too, however
 *  many it explains: their noise does not grow. */
TEST(StartWindow, ComparesWithOtherStructuresWhenThePixelsFitWorseThanBefore)
{
    SimulatedStartOptions options;
    options.start = {{0.25, 0.5, 1.0, 4.0}};
    options.start.good_inlier_ratio = 0.0;
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
        SimulatedStart start(options, seed);
        for (int look = 0; look < 3; ++look) ASSERT_TRUE(start.run()) << seed;
        start.misguide(Guess::Mirrored);
        const auto refined = start.run();
        ASSERT_TRUE(refined) << seed;
        const double s = scaleOf(refined->belief, start.frame());
        EXPECT_LT(errorOf(refined->belief, start.frame(), s).head<3>().norm(),
                  0.03 * refined->belief.x.head<3>().norm())
            << seed;
        EXPECT_GT(refined->belief.x(0), 0.0) << seed;
    }
}

/** Where the filter believes in a rotation, no threshold of the parallax is ever passed. */
TEST(StartWindow, FindsAParallaxThatTheFilterDoesNotSee)
{
    SimulatedStartOptions options;
    options.guess = Guess::Still;
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
        SimulatedStart start(options, seed);
        const auto refined = start.run();
        ASSERT_TRUE(refined) << seed;
        EXPECT_LT(start.frame(), 40) << seed;
        const double s = scaleOf(refined->belief, start.frame());
        const Vector6d e = errorOf(refined->belief, start.frame(), s);
        EXPECT_LT(e.head<3>().norm(), 0.05 * refined->belief.x.head<3>().norm()) << seed;
    }
}

TEST(StartWindow, KnowsHowWellItKnowsPoseAndVelocity)
{
    constexpr int kRuns = 50;
    double pose = 0.0;
    double orientation = 0.0;
    double velocity = 0.0;
    for (unsigned seed = 1; seed <= kRuns; ++seed)
    {
        SimulatedStart start({}, seed);
        const auto refined = start.run();
        ASSERT_TRUE(refined) << seed;
        const double s = scaleOf(refined->belief, start.frame());
        const Vector6d e = errorOf(refined->belief, start.frame(), s);
        const Matrix6d P = poseErrorCovariance(refined->belief.pose(), refined->belief.P);
        pose += nees(e, P).value();
        orientation += e.tail<3>().dot(P.bottomRightCorner<3, 3>().ldlt().solve(e.tail<3>()));
        const Vector6d v = refined->belief.x.segment<6>(camera_state::kVelocity) -
                           SimulatedStart::meanVelocity(start.frame(), s);
        velocity +=
            nees(v, refined->belief.P.block<6, 6>(camera_state::kVelocity, camera_state::kVelocity))
                .value();
    }
    // The scale is taken from the estimate itself: five of the six numbers are free.
    EXPECT_GT(pose / kRuns, chi2MeanBounds(5, kRuns, 0.998).low);
    EXPECT_LT(pose / kRuns, chi2MeanBounds(6, kRuns, 0.998).high);
    EXPECT_GT(orientation / kRuns, chi2MeanBounds(3, kRuns, 0.998).low);
    EXPECT_LT(orientation / kRuns, chi2MeanBounds(3, kRuns, 0.998).high);
    EXPECT_GT(velocity / kRuns, chi2MeanBounds(5, kRuns, 0.998).low);
    EXPECT_LT(velocity / kRuns, chi2MeanBounds(6, kRuns, 0.998).high);
}

TEST(StartWindow, KnownPointsGiveTheScale)
{
    SimulatedStartOptions options;
    options.metric = true;
    for (const Guess guess : {Guess::Right, Guess::Mirrored})
    {
        options.guess = guess;
        SimulatedStart start(options, 3);
        const auto refined = start.run();
        ASSERT_TRUE(refined);
        EXPECT_LT(errorOf(refined->belief, start.frame(), 1.0).head<3>().norm(), 0.01);
        EXPECT_LT(worstLandmark(start, refined->belief, 1.0), 0.1);
        for (LandmarkId id = 0; id < options.known; ++id)
        {
            const Eigen::Index index = refined->belief.find(id);
            ASSERT_GE(index, 0);
            EXPECT_EQ(refined->belief.landmarks[static_cast<std::size_t>(index)].kind,
                      LandmarkKind::Point);
        }
    }
}

/** What the filter has made of them must not define the world. */
TEST(StartWindow, KnownPointsAreWhereTheyAreKnownToBe)
{
    SimulatedStartOptions options;
    options.metric = true;
    options.knownTurn_rad = 0.02;
    SimulatedStart start(options, 4);
    const auto refined = start.run();
    ASSERT_TRUE(refined);
    const auto error = errorOf(refined->belief, start.frame(), 1.0);
    EXPECT_LT(error.head<3>().norm(), 0.01);
    EXPECT_LT(error.segment<3>(3).norm(), 0.005);
}

TEST(StartWindow, LeavesTheBeliefWhereNothingExplainsThePixels)
{
    SimulatedStartOptions options;
    options.wildShare = 0.4;
    SimulatedStart start(options, 1);
    EXPECT_FALSE(start.run());
    EXPECT_LT(start.window().lastInlierRatio(), options.start.accept_inlier_ratio);
    EXPECT_GT(start.window().lastInlierRatio(), 0.3);
}

TEST(StartWindow, BelievesPixelsMoreThanTheFiltersVerdictOnThem)
{
    SimulatedStartOptions options;
    options.fate = Fate::Rejected;
    SimulatedStart rejected(options, 2);
    const auto refined = rejected.run();
    ASSERT_TRUE(refined);
    EXPECT_EQ(refined->belief.landmarks.size(), SimulatedStart::kLandmarks);
    options.fate = Fate::NotFound;
    SimulatedStart unseen(options, 2);
    EXPECT_FALSE(unseen.run());
}

TEST(StartWindow, DropsLandmarksThatDoNotStandStill)
{
    SimulatedStartOptions options;
    options.wandering = {4, 17};
    SimulatedStart start(options, 4);
    const auto refined = start.run();
    ASSERT_TRUE(refined);
    EXPECT_EQ(refined->belief.landmarks.size(),
              SimulatedStart::kLandmarks - options.wandering.size());
    for (const LandmarkId id : options.wandering) EXPECT_EQ(refined->belief.find(id), -1);
    EXPECT_LT(worstLandmark(start, refined->belief, scaleOf(refined->belief, start.frame())), 0.1);
}

TEST(StartWindow, ClosesWhenTheCameraHasTurnedAwayFromWhatItKnows)
{
    SimulatedStartOptions options;
    options.inViewAtTheEnd = 25;
    EXPECT_TRUE(SimulatedStart(options, 5).run());
    options.inViewAtTheEnd = 10;
    SimulatedStart turning(options, 5);
    EXPECT_FALSE(turning.run());
    EXPECT_FALSE(turning.window().open());
}

TEST(StartWindow, EstimatesAnewAtEachThresholdAndThenCloses)
{
    SimulatedStartOptions options;
    options.start.parallax_deg = {2.0, 4.0, 6.0};
    SimulatedStart start(options, 5);
    std::vector<int> at;
    while (start.window().open() && start.frame() < 100)
        if (start.step()) at.push_back(start.frame());
    ASSERT_GE(at.size(), 3U);
    EXPECT_FALSE(start.window().open());
    EXPECT_FALSE(start.step());
    // 2 degrees a metre and a quarter away are 4.5 cm, nine frames.
    EXPECT_NEAR(at.front(), 9, 4);
    EXPECT_NEAR(at.back(), 27, 9);
}

TEST(StartWindow, ClosesUnfinishedAfterItsLastFrame)
{
    SimulatedStartOptions options;
    options.start.parallax_deg = {60.0};
    options.start.max_frames = 20;
    SimulatedStart start(options, 6);
    for (int k = 0; k < options.start.max_frames; ++k)
    {
        EXPECT_FALSE(start.step());
        EXPECT_TRUE(start.window().open()) << k;
    }
    EXPECT_FALSE(start.step());
    EXPECT_FALSE(start.window().open());
}
}  // namespace monoslam
