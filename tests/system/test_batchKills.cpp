// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <random>

#include "BatchFolder.h"

namespace monoslam
{
namespace
{
constexpr int kKills = 10;

class BatchKills : public BatchFolder
{
   protected:
    [[nodiscard]] long jobsEnded() const
    {
        const std::string out = folder_ / "out";
        if (!std::filesystem::exists(out)) return 0;
        const std::filesystem::recursive_directory_iterator files(out);
        return std::count_if(begin(files), end(files),
                             [](const auto& entry)
                             { return entry.path().filename() == "job.json"; });
    }
};

/** Killed at ten moments, anywhere between the first check and the last job. */
TEST_F(BatchKills, TenOfThemChangeNoResult)
{
    writeBatch("strategies = spatial_nn jcbb\nseeds = 1-15\n");
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(batch("--output '" + (folder_ / "undisturbed") + "'").status, 0);
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;

    const unsigned seed = std::random_device{}();
    std::mt19937 random(seed);
    std::string killed = "seed " + std::to_string(seed) + "; killed after";
    // A whole run's time for ten kills, so that none comes after the end.
    std::uniform_real_distribution<double> moment_s(0.0, 2.0 * whole.count() / kKills);
    for (int i = 0; i < kKills; ++i)
    {
        const std::string after_s = std::to_string(moment_s(random));
        const auto result = batch({}, "timeout --foreground -s KILL " + after_s);
        killed += " " + after_s + " s (" + std::to_string(jobsEnded()) + " of 60 jobs had ended)";
        EXPECT_TRUE(result.status == 137 || result.status == 0) << result.output;
    }
    std::printf("%s\n", killed.c_str());
    const auto last = batch();
    ASSERT_EQ(last.status, 0) << last.output;
    EXPECT_EQ(withoutTimes(results()), withoutTimes(results("undisturbed"))) << killed;
}
}  // namespace
}  // namespace monoslam
