// SPDX-License-Identifier: BSD-3-Clause
#include "srgbCurve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace monoslam
{
TEST(SrgbCurve, IsTheStandards)
{
    EXPECT_NEAR(srgbByPower(0.0).value, 0.0, 1e-15);
    EXPECT_NEAR(srgbByPower(0.02).value, 0.02 / 12.92, 1e-15);
    EXPECT_NEAR(srgbByPower(0.5).value, 0.21404114, 1e-8);
    EXPECT_NEAR(srgbByPower(1.0).value, 1.0, 1e-15);
}

TEST(SrgbCurve, ItsTableAgreesWithItAndItsSlopeWithBoth)
{
    constexpr double kStep = 1e-6;
    for (double v = -0.1; v < 1.2; v += 0.00037)
    {
        EXPECT_NEAR(srgb(v).value, srgbByPower(v).value, 1e-9) << v;
        EXPECT_NEAR(srgb(v).slope, srgbByPower(v).slope, 1e-7) << v;
        const double rise = srgbByPower(v + kStep).value - srgbByPower(v - kStep).value;
        const bool kink = std::abs(v - 0.04045) < 2.0 * kStep;  // where the standard's parts meet
        EXPECT_NEAR(srgb(v).slope, rise / (2.0 * kStep), kink ? 1e-2 : 1e-7) << v;
    }
}
}  // namespace monoslam
