// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <map>

#include "keptMap.h"
#include "mosaicRun.h"

namespace monoslam
{
namespace
{
MonoSlamOptions delayed()
{
    MonoSlamOptions o;
    o.initialization.method = InitializationMethod::Delayed;
    o.initialization.rho0 = 2.0;
    o.initialization.max_candidates = 20;
    o.map.measured_target = 20;
    o.map.convert_linearity = 0.0;
    return o;
}

/** Squared sigmas by which a landmark is off the plane z = 0; 1 degree of freedom. */
double offPlane2(const Belief& belief, const LandmarkSlot& slot)
{
    Matrix36d J_p_y;
    const Vector6d y = belief.x.segment<6>(slot.offset);
    const Eigen::Vector3d p_w = toPoint(y, &J_p_y);
    const Eigen::Matrix3d P_pp =
        J_p_y * belief.P.block<6, 6>(slot.offset, slot.offset) * J_p_y.transpose();
    return p_w.z() * p_w.z() / P_pp(2, 2);
}

/** Frame in which each landmark entered. */
std::map<LandmarkId, int> entries(MosaicRun& run)
{
    std::map<LandmarkId, int> entered;
    for (int k = 0; k < kFrames; ++k)
    {
        run.step(k);
        for (const auto& slot : run.belief().landmarks) entered.emplace(slot.id, k);
    }
    return entered;
}
}  // namespace

TEST(TrackCandidates, WaitInAClonesViewUntilTheirDepthIsKnownAsWellAsTheyClaim)
{
    MosaicRun run(delayed());
    run.step(0);
    EXPECT_TRUE(run.belief().landmarks.empty());
    ASSERT_EQ(run.belief().clones.size(), 1U);
    EXPECT_EQ(run.belief().clonePose(run.belief().clones.front()), run.belief().pose());
    const int waiting = run.keeper().candidates();
    ASSERT_GT(waiting, 10);

    double sum = 0.0;
    std::map<LandmarkId, int> entered;
    for (int k = 1; k < kFrames; ++k)
    {
        run.step(k);
        for (const auto& slot : run.belief().landmarks)
            if (entered.emplace(slot.id, k).second) sum += offPlane2(run.belief(), slot);
    }
    ASSERT_GT(entered.size(), 10U);
    for (const auto& [id, k] : entered) EXPECT_EQ(run.keeper().records().count(id), 1U);
    // The pixels' noise is assumed no smaller than it is, and not much larger.
    const double mean = sum / static_cast<double>(entered.size());
    EXPECT_LT(mean, 2.0);
    EXPECT_GT(mean, 0.02);
}

TEST(TrackCandidates, WereBornWhereTheirCloneIsNowKnownToHaveBeen)
{
    const Eigen::Vector3d later(0.3, -0.2, 0.1);
    MosaicRun run(delayed(), later);
    for (int k = 0; k < kFrames; ++k) run.step(k);
    ASSERT_GT(run.belief().landmarks.size(), 10U);
    for (const auto& [id, record] : run.keeper().records())
    {
        if (record.bornFrame > 0) continue;
        EXPECT_LT((record.born.pose.head<3>() - poseOf(0).head<3>() - later).norm(), 1e-12);
    }
}

TEST(TrackCandidates, EnterByParallaxBaselineAndNumberOfSightings)
{
    MosaicRun usual(delayed());
    const auto entered = entries(usual);
    ASSERT_FALSE(entered.empty());
    int first = kFrames;
    for (const auto& [id, k] : entered) first = std::min(first, k);
    // 3 degrees of parallax at 0.5 m are 2.6 cm; the fifth sighting is in frame 4.
    EXPECT_GE(first, 4);
    EXPECT_LE(first, 6);

    MonoSlamOptions o = delayed();
    o.initialization.min_seen = 9;
    MosaicRun patient(o);
    for (const auto& [id, k] : entries(patient)) EXPECT_GE(k, 8);
    o = delayed();
    o.initialization.b_min = 0.075;
    MosaicRun wide(o);
    for (const auto& [id, k] : entries(wide)) EXPECT_GE(k, 8);
    o = delayed();
    o.initialization.alpha_min_deg = 30.0;
    MosaicRun never(o);
    EXPECT_TRUE(entries(never).empty());
    o = delayed();
    o.initialization.max_relative_sigma = 1e-4;
    MosaicRun exact(o);
    EXPECT_TRUE(entries(exact).empty());
    EXPECT_GT(exact.keeper().candidates(), 0);
}

TEST(TrackCandidates, AnUnusedCloneLeavesTheState)
{
    KeptMap kept(delayed());
    kept.revise({}, texturedFrame(1));
    ASSERT_GT(kept.keeper.candidates(), 0);
    ASSERT_EQ(kept.belief().clones.size(), 1U);
    for (int k = 0; k < 4 && kept.keeper.candidates() > 0; ++k) kept.revise({}, flatFrame());
    EXPECT_EQ(kept.keeper.candidates(), 0);
    EXPECT_TRUE(kept.belief().clones.empty());
    EXPECT_EQ(kept.belief().size(), 13);
}

TEST(TrackCandidates, TheOldestCloneAndItsCandidatesMakeRoomForANewOne)
{
    MonoSlamOptions o = delayed();
    o.initialization.max_clones = 2;
    o.initialization.max_candidates = o.map.measured_target = 300;
    KeptMap kept(o);
    kept.revise({}, texturedFrame(1, 0.0, 100.0));  // each has corners where the others have none
    const int first = kept.keeper.candidates();
    kept.revise({}, texturedFrame(2, 100.0, 200.0));
    ASSERT_EQ(kept.belief().clones.size(), 2U);
    const auto before = kept.belief().clones;
    const int both = kept.keeper.candidates();
    EXPECT_GT(both, first);
    kept.revise({}, texturedFrame(3, 200.0, 320.0));
    ASSERT_EQ(kept.belief().clones.size(), 2U);
    EXPECT_EQ(kept.belief().clones.front().id, before.back().id);
    EXPECT_GT(kept.belief().clones.back().id, before.back().id);
}

TEST(TrackCandidates, InPaperModeNoPoseIsCloned)
{
    MonoSlamOptions o = delayed();
    o.initialization.clone = false;
    MosaicRun run(o);
    for (int k = 0; k < kFrames; ++k)
    {
        run.step(k);
        EXPECT_TRUE(run.belief().clones.empty());
    }
    EXPECT_GT(run.belief().landmarks.size(), 10U);
}
}  // namespace monoslam
