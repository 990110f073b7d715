// SPDX-License-Identifier: BSD-3-Clause
// Linked with test_Associator.cpp, whose contract the strategies that call MRPT are held to as well.
#include "monoslam_mrpt/registerMrptAssociators.h"

#include <gtest/gtest.h>

#include "associatorRuns.h"

namespace monoslam::test
{
namespace
{
const bool kRegistered = []
{
    registerMrptAssociators();
    return true;
}();
}  // namespace

TEST(MrptAssociators, AreNamedOnce)
{
    EXPECT_TRUE(kRegistered);
    registerMrptAssociators();
    const auto names = associatorNames();
    EXPECT_EQ(std::count(names.begin(), names.end(), "jcbb_mrpt"), 1);
}

TEST(JcbbMrpt, BelievesWhatTheJointTestRejects)
{
    LinearWorld world = LinearWorld::withLandmarks(30, 10);
    for (const LandmarkId id : {2, 9, 17, 28}) world.displace(id, {9.0, -10.0});
    const std::string oneStage = "first_stage_landmarks = 0";
    const Correction theirs = run("jcbb_mrpt", world, oneStage);
    const Correction ours = run("jcbb", world, oneStage);
    for (const LandmarkId id : {2, 9, 17, 28})
    {
        EXPECT_EQ(recordOf(theirs, id).fate, Fate::Matched);
        EXPECT_EQ(recordOf(ours, id).fate, Fate::Rejected);
    }
    EXPECT_EQ(theirs.counters.nodes, 30);
}

TEST(JcbbMrpt, GatesEachPairByItsOwnQuantile)
{
    for (const double d2 : {5.8, 6.1})  // chi2(2, 0.95) = 5.99
    {
        LinearWorld world = LinearWorld::withLandmarks(1, 12);
        const Prediction prediction = world.predict(world.belief);
        const Eigen::Matrix2d S = prediction.rows[0].S;
        const Eigen::Vector2d nu(std::sqrt(d2 / S.inverse()(0, 0)), 0.0);
        world.seen[0] = {{prediction.rows[0].h + nu, 0.9, world.R()}};
        const Correction correction = run("jcbb_mrpt", world);
        EXPECT_EQ(correction.associations[0].fate, d2 < 5.99 ? Fate::Matched : Fate::Rejected);
    }
}

TEST(JcbbMrpt, ChoosesTheNearerCandidateOfItsOwnLandmark)
{
    LinearWorld world = LinearWorld::withLandmarks(3, 13);
    const Prediction prediction = world.predict(world.belief);
    const Eigen::Vector2d h = prediction.rows[1].h;
    const Eigen::Vector2d near = h + Eigen::Vector2d(1.0, 0.0), far = h - Eigen::Vector2d(6.0, 6.0);
    world.seen[1] = {{far, 0.95, world.R()}, {near, 0.85, world.R()}};
    const Correction correction =
        run("jcbb_mrpt", world,
            "first_stage_landmarks = 0\n[association.jcbb_mrpt]\nmax_candidates = 2");
    EXPECT_EQ(recordOf(correction, 1).fate, Fate::Matched);
    EXPECT_THROW(run("jcbb_mrpt", world, "[association.jcbb_mrpt]\nmax_candidates = 101"),
                 std::invalid_argument);
}
namespace
{
/** Every landmark with five candidates in its ellipse: MRPT would try 5^25 assignments. */
LinearWorld crowdedWorld(int landmarks)
{
    LinearWorld world = LinearWorld::withLandmarks(landmarks, 14);
    for (auto& [id, candidates] : world.seen)
        for (int c = 1; c < 5; ++c)
        {
            const double angle = 1.1 * c + 0.3 * static_cast<double>(id);
            const Eigen::Vector2d off = 4.0 * c * Eigen::Vector2d(cos(angle), sin(angle));
            candidates.push_back({candidates.front().z + off, 0.9 - 0.01 * c, world.R()});
        }
    return world;
}

const std::string kFiveCandidates =
    "first_stage_landmarks = 0\nfinal_gate_probability = 1\n[association.jcbb_mrpt]\n"
    "max_candidates = 5\n";
}  // namespace

TEST(JcbbMrpt, TakesTheNearestCandidatesWhenItsTimeIsOverAndSaysSo)
{
    const LinearWorld world = crowdedWorld(25);
    const Correction capped = run("jcbb_mrpt", world, kFiveCandidates + "time_cap_s = 0.02");
    EXPECT_EQ(capped.counters.capped, 1);
    EXPECT_FALSE(capped.counters.provedOptimal);
    EXPECT_GE(capped.counters.otherThreadsMs, 10.0);
    EXPECT_LT(capped.counters.otherThreadsMs, 500.0);
    expectSound(capped, world);
    const Correction nearest = run("spatial_nn", world, "first_stage_landmarks = 0");
    for (const Association& record : capped.associations)
    {
        if (record.fate != Fate::Matched) continue;
        EXPECT_EQ(record.z, recordOf(nearest, record.id).z) << record.id;
    }
    EXPECT_GT(count(capped, Fate::Matched), 15);
}

TEST(JcbbMrpt, GivesOneFrameOneCapForAllItsSearches)
{
    const Correction stages =
        run("jcbb_mrpt", crowdedWorld(40),
            "first_stage_distance_px = 20\n[association.jcbb_mrpt]\nmax_candidates = 5\n"
            "time_cap_s = 0.02");
    EXPECT_GT(stages.counters.capped, 1);
    EXPECT_LT(stages.counters.otherThreadsMs, 60.0);
}

TEST(JcbbMrpt, FindsTheSameInAChildAndInThisProcess)
{
    const LinearWorld world = crowdedWorld(4);
    const Correction child = run("jcbb_mrpt", world, kFiveCandidates + "time_cap_s = 100");
    const Correction here = run("jcbb_mrpt", world, kFiveCandidates + "time_cap_s = 0");
    EXPECT_EQ(child.counters.capped, 0);
    EXPECT_TRUE(child.counters.provedOptimal);
    EXPECT_GT(here.counters.nodes, 0);
    EXPECT_EQ(child.counters.nodes, here.counters.nodes);
    EXPECT_EQ(best(child.mixture).x, best(here.mixture).x);
}
}  // namespace monoslam::test
