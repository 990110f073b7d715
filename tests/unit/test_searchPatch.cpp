// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/searchPatch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "texture.h"

namespace monoslam
{
namespace
{
constexpr int kWidth_px = 120;
constexpr int kHeight_px = 90;

std::shared_ptr<const PreparedImage> textured(unsigned seed, double du = 0.0, double dv = 0.0,
                                              double noise_grey = 0.0)
{
    const Texture texture(seed);
    return prepareImage(
        renderImage(
            kWidth_px, kHeight_px, [&](double u, double v) { return texture.at(u - du, v - dv); },
            noise_grey, seed),
        0.7);
}

Patch patchAt(const std::shared_ptr<const PreparedImage>& image, const Eigen::Vector2d& uv,
              int half_px = 6)
{
    Appearance born;
    born.image = image;
    born.uv_px = uv;
    return *samplePatch(born, PredictedWarp{}, half_px);
}

/** Definition: correlation coefficient of template and window. */
double textbookZncc(const PreparedImage& image, const Patch& patch, int u, int v)
{
    const int half = patch.half_px;
    const double n = patch.side() * patch.side();
    double meanT = 0.0;
    double meanI = 0.0;
    for (int y = -half; y <= half; ++y)
        for (int x = -half; x <= half; ++x)
        {
            meanT += static_cast<double>(patch.at(x, y)) / n;
            meanI += image.levels[0].at<std::uint8_t>(v + y, u + x) / n;
        }
    double cross = 0.0;
    double squareT = 0.0;
    double squareI = 0.0;
    for (int y = -half; y <= half; ++y)
        for (int x = -half; x <= half; ++x)
        {
            const double t = static_cast<double>(patch.at(x, y)) - meanT;
            const double i = image.levels[0].at<std::uint8_t>(v + y, u + x) - meanI;
            cross += t * i;
            squareT += t * t;
            squareI += i * i;
        }
    return cross / std::sqrt(squareT * squareI);
}

PatchSearchRegion circle(double u, double v, double radius_px)
{
    PatchSearchRegion region;
    region.centre_px = {u, v};
    region.S = Eigen::Matrix2d::Identity();
    region.gate = radius_px * radius_px;
    return region;
}

TEST(Correlate, EqualsTheTextbookForm)
{
    const auto image = textured(1, 0, 0, 3.0);
    const auto other = textured(2, 0, 0, 3.0);
    for (const int half : {2, 5, 6, 7, 8, 15})
    {
        const Patch patch = patchAt(image, {50, 40}, half);
        const Patch foreign = patchAt(other, {60.3, 41.7}, half);
        for (int v = 20; v < kHeight_px - 20; v += 7)
            for (int u = 20; u < kWidth_px - 20; u += 7)
                for (const Patch* p : {&patch, &foreign})
                    ASSERT_NEAR(correlate(*image, *p, u, v), textbookZncc(*image, *p, u, v), 2e-3);
    }
}

TEST(Correlate, IsOneAtTheBirthPixelAndUndefinedOutside)
{
    const auto image = textured(1);
    const Patch patch = patchAt(image, {50, 40});
    EXPECT_NEAR(correlate(*image, patch, 50, 40), 1.0, 1e-6);
    EXPECT_EQ(correlate(*image, patch, 5, 40), -1.0);
    EXPECT_EQ(correlate(*image, patch, kWidth_px - 6, 40), -1.0);
    EXPECT_EQ(correlate(*image, patch, 50, kHeight_px - 6), -1.0);
    EXPECT_GT(correlate(*image, patch, 6, 6), -1.0);
    EXPECT_GT(correlate(*image, patch, kWidth_px - 7, kHeight_px - 7), -1.0);
}

TEST(Correlate, IsUndefinedOnFlatGround)
{
    const Patch patch = patchAt(textured(1), {50, 40});
    const auto flat = prepareImage(cv::Mat(kHeight_px, kWidth_px, CV_8UC1, cv::Scalar(77)), 0.7);
    EXPECT_EQ(correlate(*flat, patch, 50, 40), -1.0);
}

TEST(SearchPatch, FindsTheNearestPixelOfAShift)
{
    const auto born = textured(3, 0, 0, 2.0);
    const Patch patch = patchAt(born, {50, 40});
    for (const double shift : {-3.4, -0.3, 0.2, 4.0})
    {
        const auto now = textured(3, shift, 0.4 * shift, 2.0);
        const PatchSearch found = searchPatch(*now, patch, circle(51, 41, 8));
        ASSERT_EQ(found.peaks.size(), 1U);
        EXPECT_EQ(found.peaks[0].uv_px.x(), std::round(50 + shift));
        EXPECT_EQ(found.peaks[0].uv_px.y(), std::round(40 + 0.4 * shift));
        EXPECT_GT(found.peaks[0].score, 0.9);
    }
}

TEST(SearchPatch, StaysInsideTheEllipse)
{
    const auto image = textured(3);
    const Patch patch = patchAt(image, {50, 40});
    for (const CorrelationPeak& peak : searchPatch(*image, patch, circle(60, 40, 9.5)).peaks)
        EXPECT_LT((peak.uv_px - Eigen::Vector2d(60, 40)).norm(), 9.5);
    EXPECT_EQ(searchPatch(*image, patch, circle(60, 40, 10.5)).peaks.size(), 1U);

    PatchSearchRegion slim = circle(60, 40, 1.0);
    slim.S << 144.0, 0.0, 0.0, 1.5;
    const PatchSearch found = searchPatch(*image, patch, slim);
    EXPECT_EQ(found.peaks.size(), 1U);
    EXPECT_NEAR(static_cast<double>(found.pixels), M_PI * 12.0 * std::sqrt(1.5), 12.0);
    slim.S << 1.5, 0.0, 0.0, 144.0;
    EXPECT_TRUE(searchPatch(*image, patch, slim).peaks.empty());
}

/** Two copies of one picture, side by side. */
TEST(SearchPatch, ListsEqualPlacesBestFirst)
{
    const Texture texture(5);
    const auto image = prepareImage(
        renderImage(
            kWidth_px, kHeight_px,
            [&](double u, double v) { return texture.at(std::fmod(u + 20.0, 40.0), v); }, 2.0),
        0.7);
    const Patch patch = patchAt(image, {40, 40});
    PatchSearchRegion region = circle(52, 40, 40);
    region.maxPeaks = 3;
    const PatchSearch found = searchPatch(*image, patch, region);
    ASSERT_GE(found.peaks.size(), 2U);
    EXPECT_EQ(found.peaks[0].uv_px, Eigen::Vector2d(40, 40));
    EXPECT_EQ(found.peaks[1].uv_px, Eigen::Vector2d(80, 40));
    EXPECT_GT(found.peaks[0].score, found.peaks[1].score);
    region.maxPeaks = 1;
    EXPECT_EQ(searchPatch(*image, patch, region).peaks.size(), 1U);
    region.minScore = 1.01;
    EXPECT_TRUE(searchPatch(*image, patch, region).peaks.empty());
}
/** The best of all pixels of a disc, one by one. */
CorrelationPeak exhaustiveBest(const PreparedImage& image, const Patch& patch,
                               const PatchSearchRegion& region)
{
    CorrelationPeak best{{0.0, 0.0}, -1.0};
    for (int v = 0; v < kHeight_px; ++v)
        for (int u = 0; u < kWidth_px; ++u)
        {
            const Eigen::Vector2d uv(u, v);
            const double score = correlate(image, patch, u, v);
            if ((uv - region.centre_px).squaredNorm() >= region.gate || score <= best.score)
                continue;
            best = {uv, score};
        }
    return best;
}

TEST(SearchPatch, FindsInALargeEllipseWhatAnExhaustiveSearchFinds)
{
    int same = 0;
    long pixels = 0;
    constexpr int runs = 200;
    const PatchSearchRegion region = circle(62, 44, 35);
    for (unsigned seed = 0; seed < runs; ++seed)
    {
        const Patch patch = patchAt(textured(seed), {50, 40});
        const auto now = textured(seed, 13.3 + 0.01 * seed, 5.6, 3.0);
        const CorrelationPeak expected = exhaustiveBest(*now, patch, region);
        ASSERT_GT(expected.score, region.minScore);
        const PatchSearch found = searchPatch(*now, patch, region);
        pixels += found.pixels;
        if (!found.peaks.empty() && found.peaks.front().uv_px == expected.uv_px) ++same;
    }
    EXPECT_EQ(same, runs);
    EXPECT_LT(static_cast<double>(pixels), 0.4 * runs * M_PI * region.gate);
}
}  // namespace
}  // namespace monoslam
