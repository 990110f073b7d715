// SPDX-License-Identifier: BSD-3-Clause
#include "MapKeeper.h"

#include <gtest/gtest.h>

#include "keptMap.h"
#include "monoslam_models/projectLandmark.h"

namespace monoslam
{
namespace
{
constexpr int kWanted = 12;

MonoSlamOptions fewLandmarks()
{
    MonoSlamOptions o;
    o.map.measured_target = kWanted;
    o.initialization.method = InitializationMethod::Undelayed;
    return o;
}

/** Frames until a landmark with always the same fate is gone; -1 if it outlives them. */
int lifeUnder(Fate fate, const MonoSlamOptions& options, bool starting = false)
{
    KeptMap kept(options);
    const auto ids = kept.addFirst();
    kept.keeper.setStarting(starting);
    for (int frames = 1; frames <= 40; ++frames)
    {
        kept.revise({ids[3]}, fate);
        EXPECT_TRUE(kept.holds(ids[4]));  // was never looked for
        if (!kept.holds(ids[3])) return frames;
        EXPECT_EQ(kept.keeper.removed(), 0);
    }
    return -1;
}
}  // namespace

TEST(MapKeeper, StrikesRemoveOnlyWhenTheyComeTogether)
{
    MonoSlamOptions o = fewLandmarks();
    o.map.strikes = 3;
    o.map.strike_frames = 10;
    o.map.min_searched = 1000;  // the ratio shall not matter
    EXPECT_EQ(lifeUnder(Fate::Rejected, o), 3);
    EXPECT_EQ(lifeUnder(Fate::Rejected, o, true), -1);  // while starting none counts
    KeptMap kept(o);
    const auto ids = kept.addFirst();
    for (int frames = 1; frames <= 40; ++frames)  // in any 10 frames there are 2
        kept.revise({ids[3]}, frames % 5 == 0 ? Fate::Rejected : Fate::Matched);
    EXPECT_TRUE(kept.holds(ids[3]));
    kept.revise({ids[3]}, Fate::Rejected);
    EXPECT_FALSE(kept.holds(ids[3]));
    EXPECT_EQ(kept.keeper.removed(), 1);
}

TEST(MapKeeper, ThePapersRuleDeletesOnTheFirstRejection)
{
    MonoSlamOptions o = fewLandmarks();
    o.map.delete_on_reject = true;
    EXPECT_EQ(lifeUnder(Fate::Rejected, o), 1);
    EXPECT_EQ(lifeUnder(Fate::Matched, o), -1);
}

TEST(MapKeeper, WhatIsFoundTooRarelyLeavesOnceItHasBeenSearchedOftenEnough)
{
    MonoSlamOptions o = fewLandmarks();
    o.map.min_searched = 5;
    o.map.min_found_ratio = 0.5;
    EXPECT_EQ(lifeUnder(Fate::NotFound, o), 6);
    EXPECT_EQ(lifeUnder(Fate::NotFound, o, true), 16);  // three times as long while starting
    EXPECT_EQ(lifeUnder(Fate::NotSearched, o), -1);
    EXPECT_EQ(lifeUnder(Fate::Matched, o), -1);
    KeptMap kept(o);
    const auto ids = kept.addFirst();
    for (int frames = 0; frames < 20; ++frames)
        kept.revise({ids[3]}, frames % 2 == 0 ? Fate::Matched : Fate::NotFound);
    EXPECT_TRUE(kept.holds(ids[3]));  // exactly half
    kept.revise({ids[3]}, Fate::NotFound);
    EXPECT_FALSE(kept.holds(ids[3]));
}

TEST(MapKeeper, LandmarksBecomePointsWhenTheirDepthIsAlmostLinear)
{
    const double rho = 0.8;
    const double sigma_rho = 0.01;
    const Belief belief = withLandmark(0, rho, sigma_rho);
    const double index = linearityIndex(belief.x.segment<6>(13), sigma_rho, belief.x.head<3>());
    for (const double limit : {0.99 * index, 1.01 * index, 0.0})
    {
        MonoSlamOptions o = fewLandmarks();
        o.map.convert_linearity = limit;
        KeptMap kept(o);
        kept.mixture = {{belief, 0.0}};
        kept.revise({}, Fate::Matched);
        const LandmarkSlot& slot = kept.belief().landmarks.front();
        EXPECT_EQ(slot.kind == LandmarkKind::Point, limit > index);
        if (slot.kind != LandmarkKind::Point) continue;
        const Eigen::Vector3d p_w = toPoint(belief.x.segment<6>(13));
        EXPECT_LT((kept.belief().x.segment<3>(13) - p_w).norm(), 1e-12);
    }
}

TEST(MapKeeper, ANegativeDepthBecomesAlmostInfiniteOrEndsTheLandmark)
{
    MonoSlamOptions o = fewLandmarks();
    KeptMap kept(o);
    kept.mixture = {{withLandmark(1, -0.1, 0.04, withLandmark(0, -0.1, 0.2)), 0.0}};
    kept.revise({}, Fate::Matched);
    ASSERT_EQ(kept.ids(), std::vector<LandmarkId>{0});
    EXPECT_EQ(kept.belief().x(13 + inverse_depth::kRho), 1e-3);
}

TEST(MapKeeper, ForgetsWhatTheBeliefHasLost)
{
    KeptMap kept(fewLandmarks());
    const auto ids = kept.addFirst();
    const Belief smaller = removeLandmarks(kept.belief(), {ids[0], ids[5]});
    kept.keeper.keepOnly(smaller);
    EXPECT_EQ(kept.keeper.records().size(), ids.size() - 2);
    EXPECT_EQ(kept.keeper.records().count(ids[5]), 0U);
    EXPECT_EQ(kept.keeper.removed(), 2);
}

TEST(MapKeeper, WhatANewEstimateOfTheMapLeftOutEntersAgainWhereItWasMatched)
{
    KeptMap kept(fewLandmarks());
    const auto ids = kept.addFirst();
    const Belief smaller = removeLandmarks(kept.belief(), {ids[0], ids[1], ids[2], ids[5]});
    std::vector<Association> associations;
    for (const LandmarkId id : {ids[0], ids[1], ids[2], ids[3]})
    {
        Association association;
        association.id = id;
        association.fate = id == ids[1] ? Fate::Rejected : Fate::Matched;
        association.z = {50.0 + 10.0 * static_cast<double>(id), 60.0};
        associations.push_back(association);
    }
    const Belief again = kept.keeper.addAgain(smaller, associations, {ids[2]});
    again.checkInvariant();
    EXPECT_EQ(again.landmarks.size(), smaller.landmarks.size() + 1);
    ASSERT_GE(again.find(ids[0]), 0);
    const LandmarkSlot& slot = again.landmarks[static_cast<std::size_t>(again.find(ids[0]))];
    const auto pixel = projectPixel(keptCamera(), again.camera(), slot.kind,
                                    again.x.segment(slot.offset, slot.size()));
    ASSERT_TRUE(pixel);
    EXPECT_LT((*pixel - associations[0].z).norm(), 1e-9);
}

TEST(MapKeeper, ForgetsItsCandidatesWithTheBeliefTheyWereSeenFrom)
{
    MonoSlamOptions o = fewLandmarks();
    o.initialization.method = InitializationMethod::Delayed;
    KeptMap kept(o);
    kept.revise({}, texturedFrame(1));
    ASSERT_EQ(kept.keeper.candidates(), kWanted);
    kept.keeper.keepOnly(kept.belief());
    EXPECT_EQ(kept.keeper.candidates(), 0);
}

TEST(MapKeeper, TheMapsDepthIsTheMedianOfWhatWasSeenOften)
{
    MonoSlamOptions o = fewLandmarks();
    o.map.convert_linearity = 0.0;
    KeptMap kept(o);
    const auto ids = kept.addFirst();
    EXPECT_EQ(kept.keeper.medianRho(kept.belief()), o.initialization.rho0);
    Belief& belief = kept.mixture.front().belief;
    for (std::size_t i = 0; i < ids.size(); ++i)
        belief.x(belief.landmarks[i].offset + inverse_depth::kRho) = 2.0 + static_cast<double>(i);
    const std::vector<LandmarkId> often{ids[0], ids[4], ids[9]};
    for (int k = 0; k < o.initialization.min_seen; ++k)
    {
        EXPECT_EQ(kept.keeper.medianRho(kept.belief()), o.initialization.rho0) << k;
        kept.revise(often, Fate::Matched);
    }
    EXPECT_NEAR(kept.keeper.medianRho(kept.belief()), 6.0, 1e-9);
}
}  // namespace monoslam
