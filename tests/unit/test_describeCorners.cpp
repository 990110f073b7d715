// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/describeCorners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "monoslam_models/ConstantVelocity.h"
#include "wavyPlane.h"

namespace monoslam
{
namespace
{
Vector7d overhead(double height_m, double roll_rad)
{
    return lookAt({0.01, -0.05, height_m}, {0.0, 0.0, 0.0}, roll_rad);
}

/** Corners of the first view, and where the second one has them. */
struct Pair
{
    DescribedCorners known;
    std::vector<Eigen::Vector2d> there;
};

Pair pairOf(const Vector7d& first, const Vector7d& second)
{
    Pair pair;
    const auto image = wavyView(first);
    const auto here = cornersOf(*image);
    const auto corners = pointsOfPlane(smallCamera(), first, here);
    for (std::size_t i = 0; i < here.size(); ++i) describePlace(*image, here[i], i, pair.known);
    pair.there = seenBy(smallCamera(), second, corners);
    return pair;
}

long rightOnes(const std::vector<CornerMatch>& matches, const Pair& pair)
{
    return std::count_if(matches.begin(), matches.end(),
                         [&pair](const CornerMatch& m)
                         { return (m.uv_px - pair.there[m.index]).norm() < 3.0; });
}
}  // namespace

TEST(DescribeCorners, FindsPlacesAgainFromAnotherView)
{
    const Vector7d first = overhead(0.5, 0.0);
    const std::vector<std::pair<const char*, Vector7d>> others{
        {"rolled", overhead(0.5, 0.7)},
        {"upside down", overhead(0.5, M_PI)},
        {"nearer", overhead(0.36, 0.1)},
        {"from the side", lookAt({0.12, -0.12, 0.48}, {0.02, 0.0, 0.0}, -0.2)}};
    for (const auto& [what, second] : others)
    {
        const Pair pair = pairOf(first, second);
        ASSERT_GT(pair.there.size(), 20) << what;
        const auto matches = matchCorners(pair.known, describeImage(*wavyView(second)));
        EXPECT_GE(rightOnes(matches, pair), 6) << what << ", of " << matches.size();
        EXPECT_GE(2 * rightOnes(matches, pair), static_cast<long>(matches.size())) << what;
    }
}

TEST(DescribeCorners, MatchesEachPlaceAtMostOnceAndLittleOfAnotherScene)
{
    const Vector7d pose = overhead(0.5, 0.0);
    const Pair pair = pairOf(pose, pose);
    const auto same = matchCorners(pair.known, describeImage(*wavyView(pose)));
    const auto other = matchCorners(pair.known, describeImage(*wavyView(pose, 2)));
    EXPECT_GT(2 * same.size(), pair.there.size());
    EXPECT_LT(2 * other.size(), same.size());
    std::set<std::size_t> places;
    for (const CornerMatch& match : same) EXPECT_TRUE(places.insert(match.index).second);
}

TEST(DescribeCorners, DescribesNothingAtTheBorderOrWhereThereIsNothing)
{
    const auto image = wavyView(overhead(0.5, 0.0));
    DescribedCorners all;
    describePlace(*image, {3.0, 90.0}, 0, all);
    EXPECT_TRUE(all.uv_px.empty());
    EXPECT_TRUE(matchCorners(all, describeImage(*image)).empty());
    describePlace(*image, {100.25, 90.5}, 7, all);
    ASSERT_EQ(all.index.size(), 3U);  // a row each scale
    ASSERT_EQ(all.descriptors.rows, 3);
    for (std::size_t row = 0; row < 3; ++row)
    {
        EXPECT_EQ(all.index[row], 7U);
        EXPECT_NEAR((all.uv_px[row] - Eigen::Vector2d(100.25, 90.5)).norm(), 0.0, 1e-4);
    }
    const auto flat = prepareImage(cv::Mat(180, 240, CV_8UC1, cv::Scalar(90)), 0.7);
    EXPECT_TRUE(describeImage(*flat).uv_px.empty());
    EXPECT_TRUE(matchCorners(all, describeImage(*flat)).empty());
    const auto tiny = prepareImage(cv::Mat(30, 30, CV_8UC1, cv::Scalar(90)), 0.7);
    EXPECT_TRUE(describeImage(*tiny).uv_px.empty());
}
}  // namespace monoslam
