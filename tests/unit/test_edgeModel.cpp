// SPDX-License-Identifier: BSD-3-Clause
#include "edgeModel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "randomValues.h"

namespace monoslam
{
namespace
{
constexpr int kMostSteps = 20;

double lightToSrgb(double light)
{
    return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

/** Four sides of a dark quadrilateral as a camera with the sRGB curve records them, noise in grey
 *  levels, all whole numbers. */
std::array<std::vector<EdgePixel>, 4> recorded(double noise_grey, double offset_px, unsigned seed)
{
    std::mt19937 rng(seed);
    std::array<std::vector<EdgePixel>, 4> sides;
    for (auto& side : sides)
    {
        const double dark = uniform(rng, 0.01, 0.03), bright = uniform(rng, 0.5, 0.8);
        const double blur_px = uniform(rng, 0.6, 1.2);
        for (int i = 0; i < 600; ++i)
        {
            const double d_px = uniform(rng, -5.0, 5.0), s = uniform(rng, -1.0, 1.0);
            const double Phi = 0.5 * std::erfc(-(d_px - offset_px) / blur_px * M_SQRT1_2);
            const double grey = 255.0 * lightToSrgb(dark + (bright - dark) * Phi);
            const double noise = normalVector<1>(rng, noise_grey)[0];
            side.push_back({d_px, s, 1.0, std::round(std::clamp(grey + noise, 0.0, 255.0))});
        }
    }
    return sides;
}
}  // namespace

/** Response, grey levels and blur explain nearly the same: full Gauss-Newton steps go from one side of
 *  that valley to the other and need not come to rest. */
TEST(EdgeModel, FitsComeToRestWithTheOffsetThatIsThere)
{
    double sum2 = 0.0;
    constexpr unsigned kRuns = 60;
    for (unsigned seed = 0; seed < kRuns; ++seed)
    {
        const auto sides = recorded(2.0, 0.7, seed);
        const auto fit = fitEdges(sides, nullptr, 2e-4);
        ASSERT_TRUE(fit) << seed;
        EXPECT_LT(fit->steps, kMostSteps) << seed;
        for (const SideFit& side : fit->sides) sum2 += std::pow(side.offset_px - 0.7, 2);
    }
    EXPECT_LT(std::sqrt(sum2 / (4 * kRuns)), 0.03);
}
}  // namespace monoslam
