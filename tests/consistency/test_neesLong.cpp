// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "averageNees.h"

namespace monoslam
{
namespace
{
TEST(NeesLong, PrintsTheFrameAtWhichEachStartLeavesItsBounds)
{
    constexpr int runs = 50;
    constexpr std::size_t frames = 1000;
    const AverageNees delayed = averageNees(delayedMetricStart(), runs, frames);
    print("DI-D clone, metric start", delayed);
    const AverageNees undelayed = averageNees(undelayedMetricStart(), runs, frames);
    print("undelayed, metric start, second-order noise", undelayed);
    const AverageNees free = averageNees(undelayedFreeStart(0.05), runs, frames);
    print("undelayed, free scale, inverse depth 1 +- 0.05 / m", free);
    for (const AverageNees* nees : {&delayed, &undelayed, &free})
        EXPECT_GE(nees->insideOfFirst(100), 90);
}
}  // namespace
}  // namespace monoslam
