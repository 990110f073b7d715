// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/SyntheticWorld.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "rowWorld.h"

namespace monoslam::test
{
namespace
{
constexpr int kFrames = 1000;
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
