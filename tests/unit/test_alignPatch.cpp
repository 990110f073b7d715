// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/alignPatch.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <vector>

#include "texture.h"

namespace monoslam
{
namespace
{
constexpr int kSide_px = 32;
constexpr double kMiddle_px = 16.0;

/** Errors and reported noise of many alignments of one texture each to its shifted self. */
struct Alignments
{
    std::vector<Eigen::Vector2d> errors;
    std::vector<Eigen::Matrix2d> R;
    std::vector<Eigen::Vector2d> slopes;
    int failed = 0;

    [[nodiscard]] Eigen::Vector2d mean() const
    {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const auto& e : errors) sum += e;
        return sum / static_cast<double>(errors.size());
    }
    [[nodiscard]] double rms() const
    {
        double sum = 0.0;
        for (const auto& e : errors) sum += 0.5 * e.squaredNorm();
        return std::sqrt(sum / static_cast<double>(errors.size()));
    }
    [[nodiscard]] double meanNis() const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < errors.size(); ++i)
            sum += errors[i].dot(R[i].inverse() * errors[i]);
        return sum / static_cast<double>(errors.size());
    }
};

struct Case
{
    double noise_grey = 0.0;
    double gain = 1.0;
    double offset_grey = 0.0;
    Eigen::Matrix2d warp = Eigen::Matrix2d::Identity();  ///< from offsets now to offsets at birth
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();     ///< missing from the predicted warp
    double sigmaSlope = 0.0;                             ///< expected of it; 0 = none
};

/** Stretch per unit of slope, as a baseline along u would give. */
const std::array<Eigen::Matrix2d, 2> kStretch{(Eigen::Matrix2d() << 0.4, 0.0, 0.0, 0.0).finished(),
                                              (Eigen::Matrix2d() << 0.0, 0.4, 0.0, 0.0).finished()};

/** What the filter would predict: the true warp but for the slope. */
PredictedWarp warpOf(const Case& what)
{
    PredictedWarp warp;
    Eigen::Matrix2d bent = Eigen::Matrix2d::Identity();
    for (std::size_t k = 0; k < 2; ++k)
        bent += kStretch[k] * what.slope(static_cast<Eigen::Index>(k));
    warp.M = what.warp * bent.inverse();
    if (what.sigmaSlope <= 0.0) return warp;
    for (std::size_t k = 0; k < 2; ++k) warp.J_M_s[k] = warp.M * kStretch[k];
    warp.slope.information = Eigen::Matrix2d::Identity() / (what.sigmaSlope * what.sigmaSlope);
    return warp;
}

Alignments alignMany(const Case& what, int count, double floor_px)
{
    Alignments result;
    std::mt19937 rng(7);
    AlignOptions options;
    options.sigmaFloor_px = floor_px;
    for (int i = 0; i < count; ++i)
    {
        const Texture texture(static_cast<unsigned>(i));
        const Eigen::Vector2d truth =
            Eigen::Vector2d::Constant(kMiddle_px) + uniformVector<2>(rng, 0.5);
        const auto born = [&](double u, double v) { return texture.at(u, v); };
        const auto now = [&](double u, double v)
        {
            const Eigen::Vector2d x =
                Eigen::Vector2d::Constant(kMiddle_px) + what.warp * (Eigen::Vector2d(u, v) - truth);
            return what.gain * texture.at(x.x(), x.y()) + what.offset_grey;
        };
        const auto seed = static_cast<unsigned>(i);
        Appearance appearance;
        appearance.image =
            prepareImage(renderImage(kSide_px, kSide_px, born, what.noise_grey, 2 * seed), 0.7);
        appearance.uv_px.setConstant(kMiddle_px);
        const auto image =
            prepareImage(renderImage(kSide_px, kSide_px, now, what.noise_grey, 2 * seed + 1), 0.7);
        const auto patch = samplePatch(appearance, warpOf(what), 6);
        const Eigen::Vector2d start(std::round(truth.x()), std::round(truth.y()));
        const auto aligned = alignPatch(*image, *patch, start, options);
        if (!aligned)
        {
            ++result.failed;
            continue;
        }
        result.errors.emplace_back(aligned->uv_px - truth);
        result.R.push_back(aligned->R);
        result.slopes.push_back(aligned->slope.mean);
    }
    return result;
}

TEST(AlignPatch, FindsShiftsWithoutBias)
{
    const Alignments found = alignMany({}, 200, 0.0);
    EXPECT_EQ(found.failed, 0);
    EXPECT_LT(found.mean().norm(), 0.005);
    EXPECT_LT(found.rms(), 0.02);
    for (const auto& e : found.errors) EXPECT_LT(e.norm(), 0.08);
}

TEST(AlignPatch, IgnoresGainAndOffset)
{
    const Alignments found = alignMany({0.0, 0.6, 35.0}, 200, 0.0);
    EXPECT_EQ(found.failed, 0);
    EXPECT_LT(found.mean().norm(), 0.005);
    EXPECT_LT(found.rms(), 0.02);
}

TEST(AlignPatch, FindsShiftsThroughAWarp)
{
    Case turned;
    const double c = std::cos(0.4);
    const double s = std::sin(0.4);
    turned.warp << c, -s, s, c;
    Case sheared;
    sheared.warp << 1.2, 0.15, -0.1, 0.8;
    for (const Case& what : {turned, sheared})
    {
        const Alignments found = alignMany(what, 200, 0.0);
        EXPECT_EQ(found.failed, 0);
        EXPECT_LT(found.mean().norm(), 0.01);
        EXPECT_LT(found.rms(), 0.03);
    }
}

TEST(AlignPatch, FindsTheSlopeThatTheWarpDoesNotKnow)
{
    Case slanted;
    slanted.slope << 0.5, -0.3;
    slanted.sigmaSlope = 0.5;
    const Alignments found = alignMany(slanted, 200, 0.0);
    EXPECT_LE(found.failed, 2);
    EXPECT_LT(found.mean().norm(), 0.005);
    EXPECT_LT(found.rms(), 0.02);
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const auto& slope : found.slopes) mean += slope / static_cast<double>(found.slopes.size());
    EXPECT_LT((mean - slanted.slope).norm(), 0.03);

    slanted.sigmaSlope = 0.0;  // the same warp taken for certain shifts the match
    EXPECT_GT(alignMany(slanted, 200, 0.0).rms(), 2.0 * found.rms());
}

TEST(AlignPatch, KeepsTheExpectedSlopeWhereTheStretchDoesNotShowIt)
{
    Case same;
    same.sigmaSlope = 1e-3;
    const Alignments free = alignMany({4.0}, 100, 0.0);
    same.noise_grey = 4.0;
    const Alignments held = alignMany(same, 100, 0.0);
    ASSERT_EQ(free.R.size(), held.R.size());
    for (std::size_t i = 0; i < free.R.size(); ++i)
    {
        EXPECT_LT((free.errors[i] - held.errors[i]).norm(), 1e-2);
        EXPECT_LT((free.R[i] - held.R[i]).norm(), 0.05 * free.R[i].norm());
    }
}

TEST(AlignPatch, ReportsTheNoiseThatItHas)
{
    const Alignments found = alignMany({4.0}, 400, 0.0);
    EXPECT_EQ(found.failed, 0);
    EXPECT_LT(found.mean().norm(), 0.02);
    EXPECT_GT(found.meanNis(), 1.4);
    EXPECT_LT(found.meanNis(), 2.8);
}

TEST(AlignPatch, AddsTheFloorToTheNoise)
{
    const Alignments without = alignMany({2.0}, 5, 0.0);
    const Alignments with = alignMany({2.0}, 5, 0.3);
    for (std::size_t i = 0; i < with.R.size(); ++i)
        EXPECT_LT((with.R[i] - without.R[i] - 0.09 * Eigen::Matrix2d::Identity()).norm(), 1e-12);
}

TEST(AlignPatch, RefusesAnotherPictureAndTheBorder)
{
    const Texture texture(1);
    const Texture other(2);
    Appearance born;
    born.image = prepareImage(
        renderImage(kSide_px, kSide_px, [&](double u, double v) { return texture.at(u, v); }), 0.7);
    born.uv_px.setConstant(kMiddle_px);
    const auto patch = samplePatch(born, PredictedWarp{}, 6);
    const auto strange = prepareImage(
        renderImage(kSide_px, kSide_px, [&](double u, double v) { return other.at(u, v); }), 0.7);
    EXPECT_FALSE(alignPatch(*strange, *patch, {kMiddle_px, kMiddle_px}, {}));
    EXPECT_FALSE(alignPatch(*born.image, *patch, {3.0, kMiddle_px}, {}));
    EXPECT_FALSE(alignPatch(*born.image, *patch, {kMiddle_px, kSide_px - 3.0}, {}));
}
}  // namespace
}  // namespace monoslam
