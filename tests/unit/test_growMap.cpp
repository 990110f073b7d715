// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "keptMap.h"

namespace monoslam
{
namespace
{
constexpr int kWanted = 12;

MonoSlamOptions fewLandmarks(InitializationMethod method = InitializationMethod::Undelayed)
{
    MonoSlamOptions o;
    o.map.measured_target = kWanted;
    o.initialization.method = method;
    return o;
}

/** Four known points a metre ahead. */
MetricPose target()
{
    MetricPose found;
    found.pose = cameraAtOrigin().pose();
    found.P = 1e-8 * Eigen::Matrix<double, 7, 7>::Identity();
    for (const double x_m : {-0.2, 0.2})
        for (const double y_m : {-0.15, 0.15})
        {
            found.points_m.emplace_back(x_m, y_m, 1.0);
            found.pixels_px.push_back(*keptCamera().project(found.points_m.back()));
        }
    return found;
}
}  // namespace

TEST(GrowMap, FirstLandmarksAreAsManyAsShallBeMeasured)
{
    KeptMap kept(fewLandmarks());
    const auto ids = kept.addFirst();
    EXPECT_EQ(ids.size(), static_cast<std::size_t>(kWanted));
    EXPECT_EQ(kept.keeper.records().size(), ids.size());
    for (const auto& slot : kept.belief().landmarks)
    {
        EXPECT_EQ(slot.kind, LandmarkKind::InverseDepth);
        EXPECT_EQ(kept.belief().x(slot.offset + inverse_depth::kRho), 1.0);
        const Eigen::Index rho = slot.offset + inverse_depth::kRho;
        EXPECT_NEAR(kept.belief().P(rho, rho), 0.25, 1e-12);
        const auto uv = projectPixel(keptCamera(), kept.belief().camera(), slot.kind,
                                     kept.belief().x.segment<6>(slot.offset));
        ASSERT_TRUE(uv);
        EXPECT_LT((*uv - kept.keeper.records().at(slot.id).born.uv_px).norm(), 1e-9);
    }
}

TEST(GrowMap, AFullMapGivesUpWhatWasNotSeenForLongestButNoKnownPoint)
{
    MonoSlamOptions o = fewLandmarks();
    o.map.max_landmarks = kWanted + 4;
    KeptMap kept(o);
    kept.mixture = kept.keeper.addKnownPoints(std::move(kept.mixture), target(), {flatFrame(), 0});
    const auto known = kept.ids();
    const auto all = kept.addFirst();
    const std::vector<LandmarkId> others(all.begin() + 4, all.end());
    ASSERT_EQ(all.size(), static_cast<std::size_t>(o.map.max_landmarks));
    // Seen last in frame 1: the first five; in frame 2, once: the next two; the others still.
    kept.revise(others, Fate::Matched);
    kept.revise({others.begin() + 5, others.end()}, Fate::Matched);
    kept.revise({others.begin() + 7, others.end()}, Fate::Matched);
    EXPECT_EQ(kept.keeper.removed(), 0);
    kept.revise({}, texturedFrame(2));  // nothing matched: as many new ones as are wanted
    const int added = kept.keeper.added();
    ASSERT_GT(added, 5);
    EXPECT_EQ(kept.ids().size(), static_cast<std::size_t>(o.map.max_landmarks));
    EXPECT_EQ(kept.keeper.removed(), added);
    for (const LandmarkId id : known) EXPECT_TRUE(kept.holds(id));
    for (std::size_t i = 0; i < others.size(); ++i)
        EXPECT_EQ(kept.holds(others[i]), static_cast<int>(i) >= added) << i;
}

TEST(GrowMap, ReplacesWhatIsNoLongerMatched)
{
    KeptMap kept(fewLandmarks());
    const auto ids = kept.addFirst();
    std::vector<Association> matched;
    for (std::size_t i = 0; i + 4 < ids.size(); ++i)
    {
        matched.emplace_back();
        matched.back().id = ids[i];
        matched.back().fate = Fate::Matched;
    }
    kept.revise(matched, texturedFrame(2));
    EXPECT_EQ(kept.keeper.added(), 4);
    EXPECT_EQ(kept.keeper.candidates(), 0);
    for (const LandmarkId id : ids) EXPECT_TRUE(kept.holds(id));
}

TEST(GrowMap, ByTheHybridRuleOnlyTheMissingOnesEnterUndelayed)
{
    MonoSlamOptions o = fewLandmarks(InitializationMethod::Hybrid);
    o.initialization.hybrid_min_measured = 5;
    KeptMap kept(o);
    kept.revise({}, texturedFrame(1));
    EXPECT_EQ(kept.keeper.added(), 5);
    EXPECT_EQ(kept.keeper.candidates(), kWanted - 5);
    o.initialization.method = InitializationMethod::Delayed;
    KeptMap delayed(o);
    delayed.revise({}, texturedFrame(1));
    EXPECT_EQ(delayed.keeper.added(), 0);
    EXPECT_EQ(delayed.keeper.candidates(), kWanted);
    KeptMap starting(o);
    starting.keeper.setStarting(true);
    starting.revise({}, texturedFrame(1));
    EXPECT_EQ(starting.keeper.added(), kWanted);
    EXPECT_EQ(starting.keeper.candidates(), 0);
}
}  // namespace monoslam
