// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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
    const long left = count(some, Fate::NotSearched),
               beliefs = static_cast<long>(some.mixture.size());
    EXPECT_EQ(left, 40 - 15);
    EXPECT_GE(some.counters.searches, 15 * beliefs);
    EXPECT_LE(some.counters.searches, (15 + 12) * beliefs) << "the first stage's, once more";
    EXPECT_EQ(all.counters.searches, 40 * static_cast<long>(all.mixture.size()));
}

TEST_P(AssociatorContract, IgnoresTheOrderOfTheCandidates)
{
    LinearWorld world = LinearWorld::withLandmarks(20, 15);
    for (auto& [id, candidates] : world.seen)
        for (int c = 1; c < 4; ++c)
        {
            const double angle = 2.1 * c + 0.7 * static_cast<double>(id);
            const Eigen::Vector2d off = 5.0 * c * Eigen::Vector2d(std::cos(angle), std::sin(angle));
            candidates.push_back({candidates.front().z + off, 0.89 - 0.03 * c, world.R()});
        }
    const auto associator = makeAssociator(GetParam(), mrpt::config::CConfigFileMemory(""));
    const auto correct = [&](unsigned order)
    {
        FrameView view = world.view();
        std::mt19937 shuffling(order), rng(7);
        view.search = [&](SearchRegion region)
        {
            region.maxCandidates = 100;
            SearchResult found = world.search(region);
            if (order > 0)
                std::shuffle(found.candidates.begin(), found.candidates.end(), shuffling);
            return found;
        };
        return associator->correct({{world.belief, 0.0}}, view, rng);
    };
    const Correction sorted = correct(0);
    expectSound(sorted, world);
    for (const unsigned order : {1U, 2U, 3U})
    {
        const Correction shuffled = correct(order);
        EXPECT_EQ(best(sorted.mixture).x, best(shuffled.mixture).x);
        for (const Association& record : sorted.associations)
        {
            EXPECT_EQ(record.fate, recordOf(shuffled, record.id).fate) << record.id;
            EXPECT_EQ(record.z, recordOf(shuffled, record.id).z) << record.id;
        }
    }
}

TEST_P(AssociatorContract, HandlesCandidatesThatAreTheSame)
{
    LinearWorld world = LinearWorld::withLandmarks(12, 16);
    for (auto& [id, candidates] : world.seen) candidates.resize(3, candidates.front());
    const Correction correction = run(GetParam(), world);
    expectSound(correction, world);
    EXPECT_GE(count(correction, Fate::Matched), 9);
}

INSTANTIATE_TEST_SUITE_P(All, AssociatorContract, testing::ValuesIn(associatorNames()),
                         [](const auto& tested) { return tested.param; });
}  // namespace monoslam::test
