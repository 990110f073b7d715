// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "associatorRuns.h"

namespace monoslam::test
{
namespace
{
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

class AssociatorContract : public testing::TestWithParam<std::string>
{
};
}  // namespace

TEST_P(AssociatorContract, AcceptsRightPairsAndTightensTheBelief)
{
    const LinearWorld world = LinearWorld::withLandmarks(20, 1);
    const Correction correction = run(GetParam(), world);
    expectSound(correction, world);
    EXPECT_GE(count(correction, Fate::Matched), 18);
    EXPECT_LT(best(correction.mixture).P(0, 0), 1.0);
}

TEST_P(AssociatorContract, IgnoresTheOrderOfTheLandmarks)
{
    LinearWorld world = LinearWorld::withLandmarks(25, 2);
    world.displace(3, {9.0, -7.0});
    world.displace(15, {-6.0, 8.0});
    const Correction a = run(GetParam(), world), b = run(GetParam(), world.reversed());
    for (const Association& record : a.associations)
    {
        EXPECT_EQ(record.fate, recordOf(b, record.id).fate);
        EXPECT_LT((record.z - recordOf(b, record.id).z).norm(), 1e-9);
    }
    EXPECT_LT((best(a.mixture).x.head<13>() - best(b.mixture).x.head<13>()).norm(), 1e-9);
}

TEST_P(AssociatorContract, HandlesFramesWithNothingOrOneThing)
{
    LinearWorld world = LinearWorld::withLandmarks(8, 3);
    world.seen.clear();
    const Correction blind = run(GetParam(), world);
    expectSound(blind, world);
    EXPECT_EQ(count(blind, Fate::NotFound), 8);
    EXPECT_EQ(best(blind.mixture).x, world.belief.x);
    for (const int landmarks : {0, 1})
    {
        const LinearWorld small = LinearWorld::withLandmarks(landmarks, 4);
        const Correction correction = run(GetParam(), small);
        expectSound(correction, small);
        EXPECT_EQ(count(correction, Fate::Matched), landmarks);
    }
}

TEST_P(AssociatorContract, SurvivesAFrameOfWrongCandidatesAndOneSharedPixel)
{
    LinearWorld wrong = LinearWorld::withLandmarks(15, 5), shared = wrong;
    std::mt19937 rng(5);
    std::uniform_real_distribution<double> error(-30.0, 30.0);
    for (auto& entry : wrong.seen)
        entry.second.front().z += Eigen::Vector2d(error(rng), error(rng));
    expectSound(run(GetParam(), wrong), wrong);
    for (auto& slot : shared.belief.landmarks)
        shared.belief.x.segment<2>(slot.offset) = Eigen::Vector2d(300.0, 200.0);
    for (auto& entry : shared.seen) entry.second.front().z = Eigen::Vector2d(301.0, 202.0);
    expectSound(run(GetParam(), shared, "first_stage_distance_px = 0"), shared);
}

TEST_P(AssociatorContract, DropsCandidatesAndLandmarksThatAreNoNumbers)
{
    LinearWorld world = LinearWorld::withLandmarks(10, 6);
    world.seen[0].front().z(0) = kNaN;
    world.seen[1].front().R(0, 1) = kNaN;
    world.seen[2].front().score = kNaN;
    world.seen[3].front().R.setZero();
    FrameView view = world.view();
    view.predict = [&world](const Belief& at)
    {
        Prediction prediction = world.predict(at);
        prediction.rows[4].h(1) = kNaN;
        return prediction;
    };
    view.linearize = [&world](const Eigen::VectorXd& x, const LandmarkSlot& slot)
    {
        PredictedLandmark row = world.linearize(x, slot);
        if (slot.id == 4) row.h(1) = kNaN;
        return row;
    };
    const auto associator = makeAssociator(GetParam(), mrpt::config::CConfigFileMemory(""));
    std::mt19937 rng(1);
    const Correction correction = associator->correct({{world.belief, 0.0}}, view, rng);
    for (const LandmarkId id : {0, 1, 2, 3, 4})
        EXPECT_NE(recordOf(correction, id).fate, Fate::Matched);
    EXPECT_EQ(recordOf(correction, 4).fate, Fate::NotSearched);
    EXPECT_GE(count(correction, Fate::Matched), 4);
    EXPECT_NO_THROW(best(correction.mixture).checkInvariant());
}

TEST_P(AssociatorContract, HandlesASingularOrIndefiniteCovariance)
{
    LinearWorld world = LinearWorld::withLandmarks(10, 7, 1e-7);
    world.belief.P.diagonal().tail(30).setZero();
    for (auto& entry : world.seen) entry.second.front().z = world.predict(world.belief).rows[0].h;
    expectSound(run(GetParam(), world), world);
    world.belief.P.row(0).tail(30).setConstant(1e3);
    world.belief.P.col(0).tail(30).setConstant(1e3);
    const Correction correction = run(GetParam(), world);
    EXPECT_TRUE(best(correction.mixture).x.allFinite());
}

TEST_P(AssociatorContract, RepeatsItsBits)
{
    LinearWorld world = LinearWorld::withLandmarks(30, 8);
    world.displace(11, {12.0, 3.0});
    const Correction a = run(GetParam(), world), b = run(GetParam(), world);
    EXPECT_EQ(best(a.mixture).x, best(b.mixture).x);
    EXPECT_EQ(best(a.mixture).P, best(b.mixture).P);
    EXPECT_EQ(a.counters.nodes, b.counters.nodes);
}

TEST_P(AssociatorContract, MeasuresAtMostWhatItIsTold)
{
    const LinearWorld world = LinearWorld::withLandmarks(40, 9);
    const Correction some = run(GetParam(), world, "max_measured = 15");
    const Correction all = run(GetParam(), world, "first_stage_landmarks = 0");
    EXPECT_EQ(some.counters.searches, 15 * static_cast<long>(some.mixture.size()));
    EXPECT_EQ(all.counters.searches, 40 * static_cast<long>(all.mixture.size()));
}

INSTANTIATE_TEST_SUITE_P(All, AssociatorContract, testing::ValuesIn(associatorNames()),
                         [](const auto& tested) { return tested.param; });

TEST(JointStrategies, RejectWhatNearestNeighboursBelieve)
{
    LinearWorld world = LinearWorld::withLandmarks(30, 10);
    for (const LandmarkId id : {2, 9, 17, 28}) world.displace(id, {-9.0, 10.0});
    for (const char* name : {"jcbb", "hohct"})
    {
        const Correction correction = run(name, world, "first_stage_landmarks = 0");
        for (const LandmarkId id : {2, 9, 17, 28})
            EXPECT_EQ(recordOf(correction, id).fate, Fate::Rejected) << name;
        EXPECT_EQ(count(correction, Fate::Matched), 26) << name;
        EXPECT_EQ(correction.counters.jointSearches, 1);
    }
    EXPECT_EQ(run("none", world, "first_stage_landmarks = 0").counters.rejected, 0);
}

TEST(BatchAssociator, ShrinksTheRegionsOfTheSecondStage)
{
    const LinearWorld world = LinearWorld::withLandmarks(30, 11);
    const Correction one = run("hohct", world, "first_stage_landmarks = 0");
    const Correction two = run("hohct", world);
    double areaOne = 0.0, areaTwo = 0.0;
    for (const Association& record : one.associations) areaOne += std::sqrt(record.S.determinant());
    for (const Association& record : two.associations) areaTwo += std::sqrt(record.S.determinant());
    EXPECT_LT(areaTwo, 0.5 * areaOne);
    EXPECT_GE(count(two, Fate::Matched), count(one, Fate::Matched) - 1);
}

TEST(BatchAssociator, SpatialChoosesTheNearestAndAppearanceTheBest)
{
    LinearWorld world = LinearWorld::withLandmarks(1, 12);
    const Eigen::Vector2d h = world.predict(world.belief).rows[0].h;
    const Eigen::Vector2d near = h + Eigen::Vector2d(1.0, 0.0), far = h - Eigen::Vector2d(9.0, 9.0);
    world.seen[0] = {{far, 0.95, world.R()}, {near, 0.85, world.R()}};
    EXPECT_EQ(run("spatial_nn", world).associations[0].z, near);
    EXPECT_EQ(run("appearance_nn", world).associations[0].z, far);
}

TEST(MakeAssociator, GivesNoneTheBitsOfAppearance)
{
    const LinearWorld world = LinearWorld::withLandmarks(20, 13);
    const Correction a = run("none", world), b = run("appearance_nn", world);
    EXPECT_EQ(best(a.mixture).x, best(b.mixture).x);
    EXPECT_EQ(best(a.mixture).P, best(b.mixture).P);
}

TEST(MakeAssociator, NamesWhatItKnowsAndWhatItDoesNot)
{
    try
    {
        const auto made = makeAssociator("nearest", mrpt::config::CConfigFileMemory(""));
        FAIL() << "made an unknown strategy";
    }
    catch (const std::invalid_argument& error)
    {
        const std::string message = error.what();
        for (const std::string& name : associatorNames())
            EXPECT_NE(message.find(name), std::string::npos);
    }
    const LinearWorld world = LinearWorld::withLandmarks(1, 14);
    EXPECT_THROW(run("hohct", world, "gate = 0.95"), std::invalid_argument);
    EXPECT_THROW(run("hohct", world, "[association.hohct]\ntau = 2"), std::invalid_argument);
    EXPECT_THROW(run("jcbb", world, "[association.jcbb]\nbound = perhaps"), std::invalid_argument);
}
}  // namespace monoslam::test
