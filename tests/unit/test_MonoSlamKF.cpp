// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/MonoSlamKF.h"

#include <gtest/gtest.h>

#include "randomBelief.h"

namespace monoslam
{
namespace
{
constexpr double kTolerance = 1e-9;
constexpr double kDt_s = 1.0 / 30.0;

TEST(MonoSlamKF, PredictsAsOurFilter)
{
    std::mt19937 rng(1);
    const Camera camera;
    const FilterEngine mrpt = makeMrptEngine();
    for (int trial = 0; trial < 20; ++trial)
    {
        const Belief prior = randomBelief(rng, camera, {});
        const Belief ours = ekfPredict(prior, {}, kDt_s);
        const Belief theirs = mrpt.predict(prior, {}, kDt_s);
        EXPECT_LT(largestDifference(ours.x, theirs.x), kTolerance);
        EXPECT_LT(largestDifference(ours.P, theirs.P), kTolerance);
    }
}

TEST(MonoSlamKF, UpdatesAsOurFilter)
{
    std::mt19937 rng(2);
    const Camera camera;
    const FilterEngine mrpt = makeMrptEngine();
    for (int trial = 0; trial < 20; ++trial)
    {
        const Belief prior = randomBelief(rng, camera, {});
        const Prediction prediction = predictMeasurements(prior, camera, {});
        auto pixels = randomPixels(rng, prediction);
        pixels.resize(pixels.size() / 2);
        const Belief ours = ekfUpdate(prior, prediction, pixels);
        const Belief theirs = mrpt.update(prior, prediction, pixels, nullptr);
        EXPECT_LT(largestDifference(ours.x, theirs.x), kTolerance);
        EXPECT_LT(largestDifference(ours.P, theirs.P), kTolerance);
    }
}

TEST(MonoSlamKF, IteratesAsOurFilterDoesInTwoSteps)
{
    std::mt19937 rng(3);
    const Camera camera;
    const Belief prior = randomBelief(rng, camera, {});
    const Belief predicted = ekfPredict(prior, {}, kDt_s);
    const Prediction prediction = predictMeasurements(predicted, camera, {});
    const auto pixels = randomPixels(rng, prediction);
    std::vector<LandmarkPixel> seen;
    for (const PixelMeasurement& p : pixels)
        seen.push_back({prediction.rows[static_cast<std::size_t>(p.row)].id, p.z, p.R});
    const Belief ours = ekfUpdate(predicted, prediction, pixels);
    const Belief theirs = mrptIteration(prior, camera, {}, kDt_s, seen);
    EXPECT_LT(largestDifference(ours.x, theirs.x), kTolerance);
    EXPECT_LT(largestDifference(ours.P, theirs.P), kTolerance);
}

TEST(MonoSlamKF, RefusesPointsAndClones)
{
    std::mt19937 rng(4);
    const FilterEngine mrpt = makeMrptEngine();
    const Belief points = randomBelief(rng, Camera(), {2, 1, false});
    const Belief clones = randomBelief(rng, Camera(), {2, 0, true});
    EXPECT_THROW((void)mrpt.predict(points, {}, kDt_s), std::invalid_argument);
    EXPECT_THROW((void)mrpt.predict(clones, {}, kDt_s), std::invalid_argument);
}
}  // namespace
}  // namespace monoslam
