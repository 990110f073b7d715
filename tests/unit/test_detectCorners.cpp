// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/detectCorners.h"

#include <gtest/gtest.h>

#include <map>

#include "texture.h"

namespace monoslam
{
namespace
{
constexpr int kWidth_px = 320;
constexpr int kHeight_px = 240;

std::shared_ptr<const PreparedImage> textured()
{
    const Texture texture(4);
    return prepareImage(
        renderImage(kWidth_px, kHeight_px, [&](double u, double v) { return texture.at(u, v); }),
        0.7);
}

std::vector<Corner> detect(const PreparedImage& image, const std::vector<Eigen::Vector2d>& taken,
                           int wanted, unsigned seed, const DetectionOptions& options = {})
{
    std::mt19937 rng(seed);
    double strongest = 0.0;
    return detectCorners(image, taken, wanted, options, strongest, rng);
}

TEST(DetectCorners, SameSeedSameCorners)
{
    const auto image = textured();
    const auto first = detect(*image, {}, 20, 5);
    const auto again = detect(*image, {}, 20, 5);
    const auto other = detect(*image, {}, 20, 6);
    ASSERT_EQ(first.size(), 20U);
    ASSERT_EQ(again.size(), first.size());
    bool differs = false;
    for (std::size_t i = 0; i < first.size(); ++i)
    {
        EXPECT_EQ(first[i].uv_px, again[i].uv_px);
        EXPECT_EQ(first[i].response, again[i].response);
        differs = differs || i >= other.size() || first[i].uv_px != other[i].uv_px;
    }
    EXPECT_TRUE(differs);
}

TEST(DetectCorners, KeepsAwayFromTakenPixelsTheBorderAndEachOther)
{
    const auto image = textured();
    const DetectionOptions options;
    std::mt19937 rng(3);
    std::vector<Eigen::Vector2d> occupied;
    for (int i = 0; i < 25; ++i)
        occupied.emplace_back(uniform(rng, 0, kWidth_px), uniform(rng, 0, kHeight_px));
    const auto corners = detect(*image, occupied, 60, 1, options);
    ASSERT_GT(corners.size(), 10U);
    for (const Corner& corner : corners)
    {
        for (const auto& pixel : occupied)
            EXPECT_GE((corner.uv_px - pixel).norm(), options.minDistance_px - 1.5);
        EXPECT_GE(corner.uv_px.minCoeff(), options.border_px);
        EXPECT_LT(corner.uv_px.x(), kWidth_px - options.border_px);
        EXPECT_LT(corner.uv_px.y(), kHeight_px - options.border_px);
        occupied.push_back(corner.uv_px);
    }
}

TEST(DetectCorners, SpreadsOverTheCells)
{
    const auto image = textured();
    DetectionOptions options;
    options.maxCells = 1000;
    std::map<std::pair<int, int>, int> perCell;
    const auto cellOf = [&](const Eigen::Vector2d& uv)
    {
        return std::pair(static_cast<int>(uv.x()) * options.gridColumns / kWidth_px,
                         static_cast<int>(uv.y()) * options.gridRows / kHeight_px);
    };
    const std::vector<Eigen::Vector2d> taken{{20, 20}, {100, 100}, {103, 118}, {90, 100}};
    for (const auto& pixel : taken) ++perCell[cellOf(pixel)];
    for (const Corner& corner : detect(*image, taken, 1000, 1, options))
        ++perCell[cellOf(corner.uv_px)];
    EXPECT_GT(perCell.size(), 40U);
    for (const auto& [cell, count] : perCell) EXPECT_LE(count, options.maxPerCell);
}

TEST(DetectCorners, FindsNothingOnFlatGroundOrAlongAnEdge)
{
    const auto flat = prepareImage(cv::Mat(kHeight_px, kWidth_px, CV_8UC1, cv::Scalar(90)), 0.7);
    EXPECT_TRUE(detect(*flat, {}, 50, 1).empty());
    const auto edge = prepareImage(
        renderImage(kWidth_px, kHeight_px,
                    [](double u, double v) { return u + 0.7 * v > 250 ? 200.0 : 60.0; }),
        0.7);
    DetectionOptions options;
    options.minResponse = 1e-3;
    EXPECT_TRUE(detect(*edge, {}, 50, 1, options).empty());
}

/** A grid of equal dots: each looks like its neighbours 10 px away. */
TEST(DetectCorners, AvoidsWhatLooksLikeItsSurroundings)
{
    const auto dots = prepareImage(
        renderImage(kWidth_px, kHeight_px,
                    [](double u, double v)
                    { return 128 + 80 * std::cos(0.2 * M_PI * u) * std::cos(0.2 * M_PI * v); }),
        0.7);
    EXPECT_TRUE(detect(*dots, {}, 50, 1).empty());
    DetectionOptions any;
    any.maxSelfSimilarity = 1.0;
    EXPECT_GT(detect(*dots, {}, 50, 1, any).size(), 20U);
}
}  // namespace
}  // namespace monoslam
