// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <random>

#include "BatchFolder.h"

namespace monoslam
{
namespace
{
using BatchKills = BatchFolder;
constexpr int kKills = 10;

/** Killed at ten moments, anywhere between the first check and the last job. */
TEST_F(BatchKills, TenOfThemChangeNoResult)
{
    writeBatch("strategies = spatial_nn jcbb\nseeds = 1-15\n");
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(batch("--output '" + (folder_ / "undisturbed") + "'").status, 0);
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;

    std::mt19937 random(std::random_device{}());
    // A whole run's time for ten kills, so that none comes after the end.
    std::uniform_real_distribution<double> moment_s(0.0, 2.0 * whole.count() / kKills);
    std::string killed;
    for (int i = 0; i < kKills; ++i)
    {
        const std::string after_s = std::to_string(moment_s(random));
        const auto result = batch({}, "timeout --foreground -s KILL " + after_s);
        killed += after_s + " s: status " + std::to_string(result.status) + "\n";
        EXPECT_TRUE(result.status == 137 || result.status == 0) << result.output;
    }
    RecordProperty("kills", killed);
    const auto last = batch();
    ASSERT_EQ(last.status, 0) << last.output;
    EXPECT_EQ(withoutTimes(results()), withoutTimes(results("undisturbed"))) << killed;
}
}  // namespace
}  // namespace monoslam
