// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/BatchAssociator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "associatorRuns.h"

namespace monoslam::test
{
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

TEST(Hohct, AmongSeveralCandidatesTakesTheLargestCompatibleAssignment)
{
    LinearWorld world = LinearWorld::withLandmarks(12, 10);
    std::map<LandmarkId, Eigen::Vector2d> truth;
    for (auto& [id, candidates] : world.seen)
    {
        truth[id] = candidates.front().z;
        Candidate decoy = candidates.front();
        decoy.score = 0.99;
        decoy.z += Eigen::Vector2d(id % 2 == 0 ? 14.0 : -12.0, id % 3 == 0 ? 11.0 : -13.0);
        candidates.insert(candidates.begin(), decoy);
    }
    const std::string ini = "first_stage_landmarks = 0\n[association.hohct]\nmax_candidates = ";
    const Correction several = run("hohct", world, ini + "2");
    EXPECT_EQ(count(several, Fate::Matched), 12);
    for (const auto& [id, z] : truth) EXPECT_EQ(recordOf(several, id).z, z) << id;
    EXPECT_TRUE(several.counters.provedOptimal);
    EXPECT_GT(several.counters.nodes, 12);
    EXPECT_LT(count(run("hohct", world, ini + "1"), Fate::Matched), 12);
    EXPECT_FALSE(run("hohct", world, ini + "2\nassignment_node_cap = 5").counters.provedOptimal);
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

/** 16 of 30 landmarks have a better looking double 12 px to the left, as on a chessboard. */
LinearWorld doubledWorld(unsigned seed)
{
    LinearWorld world = LinearWorld::withLandmarks(30, seed);
    for (auto& [id, candidates] : world.seen)
    {
        if (id > 15) continue;
        Candidate twin = candidates.front();
        twin.score = 0.99;
        twin.z += Eigen::Vector2d(-12.0, 0.0);
        candidates.insert(candidates.begin(), twin);
    }
    return world;
}

TEST(BatchAssociator, ChoosesAmongSeveralCandidatesOfTheFirstStage)
{
    // The best looking ones of the first stage agree with each other, and with nothing else.
    const std::string ini = "first_stage_distance_px = 0\nfirst_stage_landmarks = 20\n";
    std::ptrdiff_t right = 0, rightOfOne = 0;
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
        const LinearWorld world = doubledWorld(seed);
        const auto rightly = [&](const Correction& correction)
        {
            return std::count_if(
                correction.associations.begin(), correction.associations.end(),
                [&](const Association& a)
                { return a.fate == Fate::Matched && a.z == world.seen.at(a.id).back().z; });
        };
        right += rightly(run("hohct", world, ini));
        rightOfOne += rightly(run("hohct", world, ini + "first_stage_candidates = 1"));
    }
    EXPECT_GT(right, 0.95 * 300);
    EXPECT_LT(rightOfOne, 0.5 * 300);
}

TEST(BatchAssociator, SearchesWhatTheFirstStageRejectsOnceMore)
{
    for (const char* name : {"hohct", "jcbb"})
    {
        LinearWorld world = LinearWorld::withLandmarks(30, 11);
        Candidate decoy = world.seen.at(3).front();
        decoy.score = 0.99;
        decoy.z += Eigen::Vector2d(13.0, -14.0);
        world.seen.at(3).insert(world.seen.at(3).begin(), decoy);
        const std::string ini = "first_stage_distance_px = 0\nfirst_stage_candidates = 1\n";
        const Association found = recordOf(run(name, world, ini), 3);
        EXPECT_EQ(found.fate, Fate::Matched) << name;
        EXPECT_EQ(found.z, world.seen.at(3).back().z) << name;
        const Association single = recordOf(run(name, world, ini + "first_stage_landmarks = 0"), 3);
        EXPECT_EQ(single.fate, Fate::Rejected) << name;
    }
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
