// SPDX-License-Identifier: BSD-3-Clause
#include "rectangleEvidence.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace monoslam
{
namespace
{
constexpr int kLeft = 40, kTop = 30, kRight = 120, kBottom = 90;  ///< [px]

/** Half a pixel outside of the last pixels that are filled. */
Quad corners()
{
    return {Eigen::Vector2d{kLeft - 0.5, kTop - 0.5},
            {kRight + 0.5, kTop - 0.5},
            {kRight + 0.5, kBottom + 0.5},
            {kLeft - 0.5, kBottom + 0.5}};
}

cv::Mat rectangle(int inside, int outside)
{
    cv::Mat image(120, 160, CV_8UC1, cv::Scalar(outside));
    cv::rectangle(image, {kLeft, kTop}, {kRight, kBottom}, cv::Scalar(inside), cv::FILLED);
    return image;
}

/** What a fit of the four sides would have found. */
EdgeQuad fitted(int inside, int outside)
{
    EdgeQuad edges;
    edges.corners_px = corners();
    for (SideFit& side : edges.fit.sides)
    {
        side.inside = inside / 255.0;
        side.outside = outside / 255.0;
    }
    return edges;
}

double evidence(int inside, int outside)
{
    return evidenceOfRectangle(rectangle(inside, outside), fitted(inside, outside));
}
}  // namespace

TEST(RectangleEvidence, IsSquaredContrastTimesThePerimeter)
{
    const double contrast = (204 - 51) / 255.0;
    EXPECT_DOUBLE_EQ(perimeterOf(corners()), 2.0 * (81.0 + 61.0));
    EXPECT_NEAR(evidence(51, 204), contrast * contrast * 284.0, 1e-9);
    EXPECT_GT(evidence(20, 204), evidence(51, 204));
}

TEST(RectangleEvidence, IsOfTheWeakestSide)
{
    EdgeQuad edges = fitted(51, 204);
    edges.fit.sides[2].outside = 0.5;
    EXPECT_NEAR(evidenceOfRectangle(rectangle(51, 204), edges), 0.3 * 0.3 * 284.0, 1e-9);
}

TEST(RectangleEvidence, ThereIsNoneOfWhatIsNotHalfAsBright)
{
    EXPECT_GT(evidence(99, 200), 0.0);
    EXPECT_EQ(evidence(101, 200), 0.0);
    EdgeQuad edges = fitted(20, 200);
    edges.fit.sides[1].outside = 0.15;  // one side's surroundings are dark
    EXPECT_EQ(evidenceOfRectangle(rectangle(20, 200), edges), 0.0);
}

TEST(RectangleEvidence, ThereIsNoneOfAFrameRoundSomethingElse)
{
    cv::Mat image = rectangle(20, 200);
    cv::rectangle(image, {kLeft + 10, kTop + 10}, {kRight - 10, kBottom - 10}, cv::Scalar(180),
                  cv::FILLED);
    EXPECT_EQ(evidenceOfRectangle(image, fitted(20, 200)), 0.0);
}

TEST(RectangleEvidence, TheBlurOfTheSidesIsNoHole)
{
    cv::Mat small(40, 40, CV_8UC1, cv::Scalar(200));
    cv::rectangle(small, {15, 17}, {26, 24}, cv::Scalar(20), cv::FILLED);
    cv::GaussianBlur(small, small, {}, 1.2);
    EdgeQuad edges = fitted(20, 200);
    edges.corners_px = {Eigen::Vector2d{14.5, 16.5}, {26.5, 16.5}, {26.5, 24.5}, {14.5, 24.5}};
    EXPECT_GT(evidenceOfRectangle(small, edges), 0.0);
}

TEST(RectangleEvidence, RoughCornersTellDarkFromBright)
{
    Quad rough = corners();
    for (Eigen::Vector2d& corner : rough) corner += Eigen::Vector2d(2.0, -2.0);
    EXPECT_TRUE(roughlyDark(rectangle(51, 204), rough));
    EXPECT_FALSE(roughlyDark(rectangle(140, 204), rough));
    EXPECT_FALSE(roughlyDark(rectangle(204, 51), rough));
}

TEST(RectangleEvidence, WhatIsTooSmallToTellIsLeftToTheFit)
{
    EXPECT_TRUE(
        roughlyDark(rectangle(204, 51), {Eigen::Vector2d{60, 60}, {65, 60}, {65, 65}, {60, 65}}));
}
}  // namespace monoslam
