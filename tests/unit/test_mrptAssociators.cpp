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
    EXPECT_THROW(run("jcbb_mrpt", world, "[association.jcbb_mrpt]\nmax_candidates = 9"),
                 std::invalid_argument);
}
}  // namespace monoslam::test
