// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/PixelFeatures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "monoslam_eval/PairCounts.h"

namespace monoslam::test
{
namespace
{
PixelFeature featureAt(double u_px, double v_px, std::vector<Resemblance> like,
                       LandmarkId truth = kOfNoLandmark)
{
    PixelFeature feature;
    feature.z = {u_px, v_px};
    feature.resembles = std::move(like);
    feature.truth = truth;
    return feature;
}

SearchRegion regionOf(LandmarkId id, int maxCandidates = 9)
{
    SearchRegion region;
    region.id = id;
    region.centre = {100.0, 100.0};
    region.S << 16.0, 0.0, 0.0, 4.0;
    region.gate = 4.0;  // half axes 8 and 4 px
    region.maxCandidates = maxCandidates;
    return region;
}

SearchResult searchIn(const PixelFrame& frame, const SearchRegion& region)
{
    const Camera camera;
    return viewOf(frame, camera, {}).search(region);
}

Association pairOf(LandmarkId id, Fate fate, const Eigen::Vector2d& z)
{
    Association pair;
    pair.id = id;
    pair.fate = fate;
    pair.z = z;
    return pair;
}
}  // namespace

TEST(FeatureView, FindsWhatLooksAlikeInsideTheEllipse)
{
    const PixelFrame frame{
        0.0,
        {featureAt(107.9, 100.0, {{3, 0.8}}), featureAt(108.1, 100.0, {{3, 0.9}}),
         featureAt(100.0, 103.9, {{3, 0.9}, {4, 0.75}}), featureAt(100.0, 104.1, {{3, 0.9}}),
         featureAt(100.0, 100.0, {{4, 1.0}})}};
    const SearchResult result = searchIn(frame, regionOf(3));
    ASSERT_EQ(result.candidates.size(), 2);
    EXPECT_EQ(result.candidates[0].z, Eigen::Vector2d(100.0, 103.9));  // best score first
    EXPECT_EQ(result.candidates[1].z, Eigen::Vector2d(107.9, 100.0));
    EXPECT_EQ(searchIn(frame, regionOf(4)).candidates.size(), 2);
    EXPECT_TRUE(searchIn(frame, regionOf(5)).candidates.empty());
    EXPECT_EQ(result.status, SearchStatus::Done);
    EXPECT_EQ(result.pixels, std::lround(M_PI * 8.0 * 4.0));
}

TEST(FeatureView, KeepsTheBestOfThoseThatAreGoodEnough)
{
    PixelFrame frame;
    for (const double score : {0.72, 0.9, 0.8, 0.95})
        frame.features.push_back(featureAt(100.0 + score, 100.0, {{1, score}}));
    const SearchResult best = searchIn(frame, regionOf(1, 2));
    ASSERT_EQ(best.candidates.size(), 2);
    EXPECT_EQ(best.candidates[0].score, 0.95);
    EXPECT_EQ(best.candidates[1].score, 0.9);
    SearchRegion strict = regionOf(1);
    strict.minScore = 0.8;
    EXPECT_EQ(searchIn(frame, strict).candidates.size(), 3);
}

TEST(FeatureView, TakesTheNoiseOfTheFeature)
{
    PixelFrame frame{0.0, {featureAt(100.0, 100.0, {{1, 0.9}})}};
    frame.features[0].R << 2.0, 0.5, 0.5, 3.0;
    EXPECT_EQ(searchIn(frame, regionOf(1)).candidates.at(0).R, frame.features[0].R);
}

TEST(PairCounts, JudgesByTheTruthOfThePixel)
{
    const PixelFrame frame{
        0.0,
        {featureAt(10.0, 10.0, {{1, 0.9}}, 1), featureAt(12.0, 10.0, {{1, 0.9}}),
         featureAt(20.0, 20.0, {{2, 0.9}}, 2), featureAt(30.0, 30.0, {{3, 0.9}}, 3),
         featureAt(40.0, 40.0, {{4, 0.9}})}};
    PairCounts counts;
    counts.add({pairOf(1, Fate::Matched, {10.0, 10.0}), pairOf(2, Fate::Rejected, {20.0, 20.0}),
                pairOf(3, Fate::NotFound, {0.0, 0.0}), pairOf(4, Fate::Matched, {40.0, 40.0})},
               frame);
    EXPECT_EQ(counts.right, 1);
    EXPECT_EQ(counts.wrong, 1);
    EXPECT_EQ(counts.available, 3);
    EXPECT_DOUBLE_EQ(counts.precision(), 0.5);
    EXPECT_DOUBLE_EQ(counts.recall(), 1.0 / 3.0);
    counts.add({pairOf(1, Fate::Matched, {12.0, 10.0})}, frame);
    EXPECT_EQ(counts.wrong, 2);
    EXPECT_TRUE(std::isnan(PairCounts{}.precision()));
}
}  // namespace monoslam::test
