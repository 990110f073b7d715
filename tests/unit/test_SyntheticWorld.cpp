// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/SyntheticWorld.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace monoslam::test
{
namespace
{
constexpr int kFrames = 1000;

Vector13d atOrigin()
{
    Vector13d x_v = Vector13d::Zero();
    x_v[camera_state::kOrientation] = 1.0;
    return x_v;
}

/** Landmarks in a row, 2 m before the camera. */
SyntheticWorld rowOf(int count, const SyntheticWorldOptions& options, unsigned seed = 1)
{
    SyntheticWorld world(options, seed);
    for (int i = 0; i < count; ++i) world.addLandmark({0.1 * (i - 0.5 * count), 0.0, 2.0});
    return world;
}

SyntheticWorldOptions quiet()
{
    SyntheticWorldOptions options;
    options.sigma_px = 0.5;
    return options;
}

/** The feature that is the image of a landmark, or, of no landmark, that resembles it. */
std::optional<PixelFeature> find(const PixelFrame& frame, LandmarkId like, LandmarkId truth)
{
    for (const PixelFeature& feature : frame.features)
        if (feature.truth == truth && feature.resembles.at(0).landmark == like) return feature;
    return std::nullopt;
}

bool same(const PixelFrame& a, const PixelFrame& b)
{
    return a.t_s == b.t_s &&
           std::equal(a.features.begin(), a.features.end(), b.features.begin(), b.features.end(),
                      [](const PixelFeature& p, const PixelFeature& q)
                      {
                          return p.id == q.id && p.z == q.z && p.truth == q.truth &&
                                 p.resembles[0].score == q.resembles[0].score;
                      });
}
}  // namespace

TEST(SyntheticWorld, NoiseHasTheVarianceThatItClaims)
{
    const SyntheticWorld world = rowOf(3, quiet());
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (long frame = 0; frame < kFrames; ++frame)
    {
        const auto feature = find(world.observe(atOrigin(), frame), 1, 1);
        ASSERT_TRUE(feature);
        const Eigen::Vector2d e = feature->z - *world.truePixel(atOrigin(), 1);
        sum += e;
        squares += e * e.transpose();
        EXPECT_EQ(feature->R, 0.25 * Eigen::Matrix2d::Identity());
    }
    EXPECT_LT(sum.norm() / kFrames, 0.05);
    EXPECT_NEAR(squares(0, 0) / kFrames, 0.25, 0.04);
    EXPECT_NEAR(squares(1, 1) / kFrames, 0.25, 0.04);
    EXPECT_NEAR(squares(0, 1) / kFrames, 0.0, 0.03);
}

TEST(SyntheticWorld, MissesAndCluttersAsOftenAsItSays)
{
    SyntheticWorldOptions options = quiet();
    options.detectionProbability = 0.7;
    options.clutterPerImage = 4.0;
    const SyntheticWorld world = rowOf(1, options);
    double found = 0.0, clutter = 0.0, left = 0.0, trueScore = 0.0;
    for (long frame = 0; frame < kFrames; ++frame)
        for (const PixelFeature& feature : world.observe(atOrigin(), frame).features)
        {
            const double score = feature.resembles.at(0).score;
            EXPECT_TRUE(score >= options.minScore && score <= 1.0);
            EXPECT_TRUE(world.camera().contains(feature.z));
            found += feature.truth == 0 ? 1 : 0;
            trueScore += feature.truth == 0 ? score : 0;
            clutter += feature.truth == kOfNoLandmark ? 1 : 0;
            left += feature.truth == kOfNoLandmark && feature.z.x() < 320.0 ? 1 : 0;
        }
    EXPECT_NEAR(found / kFrames, 0.7, 0.05);
    EXPECT_NEAR(clutter / kFrames, 4.0, 0.25);
    EXPECT_NEAR(left / clutter, 0.5, 0.04);
    // Mean of the exponential cut off at 0.7: 1 - 1/12 + 0.3 / (exp(3.6) - 1).
    EXPECT_NEAR(trueScore / found, 1.0 - 1.0 / 12.0 + 0.3 / std::expm1(3.6), 0.01);
}

TEST(SyntheticWorld, TellsNothingByTheOrderOfFeatures)
{
    const PixelFrame frame = rowOf(20, quiet()).observe(atOrigin(), 0);
    ASSERT_EQ(frame.features.size(), 20);
    for (std::size_t i = 0; i < frame.features.size(); ++i)
    {
        EXPECT_EQ(frame.features[i].id, static_cast<std::int64_t>(i));
        EXPECT_GE(frame.features[i].z.y(), frame.features[i > 0 ? i - 1 : 0].z.y());
    }
}

TEST(SyntheticWorld, IsTheSameForASeedInWhateverOrderFramesAreSeen)
{
    const SyntheticWorld one = rowOf(5, quiet()), other = rowOf(5, quiet()),
                         third = rowOf(5, quiet(), 2);
    const PixelFrame late = one.observe(atOrigin(), 7);
    static_cast<void>(other.observe(atOrigin(), 3));
    EXPECT_TRUE(same(late, other.observe(atOrigin(), 7)));
    EXPECT_FALSE(same(late, third.observe(atOrigin(), 7)));
    EXPECT_FALSE(same(late, one.observe(atOrigin(), 8)));
    EXPECT_EQ(late.t_s, 0.2333333);  // whole ticks of 100 ns
}

TEST(WrongMatches, ShiftAGroupInTheImageForItsFramesAndNothingElse)
{
    const SyntheticWorld calm = rowOf(6, quiet());
    SyntheticWorld world = rowOf(6, quiet());
    WrongMatches group;
    group.landmarks = {1, 2, 4};
    group.firstFrame = 10;
    group.frames = 3;
    group.offset_px = {7.0, -5.0};
    world.add(group);
    for (const long frame : {9L, 13L})
        EXPECT_TRUE(same(world.observe(atOrigin(), frame), calm.observe(atOrigin(), frame)));
    for (long frame = 10; frame < 13; ++frame)
    {
        const PixelFrame wrong = world.observe(atOrigin(), frame);
        const PixelFrame right = calm.observe(atOrigin(), frame);
        for (LandmarkId id = 0; id < 6; ++id)
        {
            const bool inGroup = id == 1 || id == 2 || id == 4;
            EXPECT_EQ(find(wrong, id, id).has_value(), !inGroup);
            if (!inGroup)
            {
                EXPECT_EQ(find(wrong, id, id)->z, find(right, id, id)->z);
                continue;
            }
            const auto image = find(wrong, id, kOfNoLandmark);
            ASSERT_TRUE(image);
            const Eigen::Vector2d there = *world.truePixel(atOrigin(), id) + group.offset_px;
            EXPECT_LT((image->z - there).norm(), 5.0 * 0.5);
        }
    }
}

TEST(WrongMatches, OfATwinAreImagesOfOneShiftedObjectFromAnywhere)
{
    SyntheticWorld world = rowOf(4, quiet());
    WrongMatches group;
    group.landmarks = {0, 3};
    group.frames = 5;
    group.shift_m = {0.0, 0.2, 0.1};
    group.trueHidden = false;
    world.add(group);
    Vector13d x_v = atOrigin();
    for (long frame = 0; frame < 5; ++frame)
    {
        x_v[0] += 0.05;
        const PixelFrame seen = world.observe(x_v, frame);
        for (const LandmarkId id : group.landmarks)
        {
            EXPECT_TRUE(find(seen, id, id));
            const auto twin = find(seen, id, kOfNoLandmark);
            ASSERT_TRUE(twin);
            const auto there = projectPixel(world.camera(), x_v, LandmarkKind::Point,
                                            world.position(id) + group.shift_m);
            EXPECT_LT((twin->z - *there).norm(), 5.0 * 0.5);
        }
    }
}

TEST(LandmarkMotion, IsSeenButIsNoLongerRight)
{
    SyntheticWorld world = rowOf(2, quiet());
    world.add(LandmarkMotion{1, 10, {0.0, 0.3, 0.0}});
    EXPECT_TRUE(find(world.observe(atOrigin(), 10), 1, 1));
    const PixelFrame later = world.observe(atOrigin(), 40);
    EXPECT_FALSE(find(later, 1, 1));
    const auto moved = find(later, 1, kOfNoLandmark);
    ASSERT_TRUE(moved);
    EXPECT_NEAR(moved->z.y(), 239.5 + 500.0 * 0.3 / 2.0, 3.0);  // 0.3 m after 1 s, 2 m away
    EXPECT_TRUE(find(later, 0, 0));
}

TEST(SyntheticWorld, RefusesWhatCannotBe)
{
    SyntheticWorldOptions options;
    options.detectionProbability = 1.1;
    EXPECT_THROW(SyntheticWorld(options, 1), std::invalid_argument);
    options = {};
    options.sigma_px = 0.0;
    EXPECT_THROW(SyntheticWorld(options, 1), std::invalid_argument);
    SyntheticWorld world = rowOf(2, quiet());
    WrongMatches group;
    group.landmarks = {2};
    EXPECT_THROW(world.add(group), std::out_of_range);
    EXPECT_THROW(world.add(LandmarkMotion{5, 0, {}}), std::out_of_range);
}
}  // namespace monoslam::test
