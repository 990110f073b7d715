// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "BatchFolder.h"

namespace monoslam
{
namespace
{
namespace fs = std::filesystem;
using Batch = BatchFolder;

/** When each record of a job was written, by its path. */
std::map<std::string, fs::file_time_type> records(const std::string& folder)
{
    std::map<std::string, fs::file_time_type> times;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().filename() == "job.json")
            times[entry.path().string()] = fs::last_write_time(entry.path());
    return times;
}

std::size_t count(const std::string& text, const std::string& word)
{
    std::size_t n = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
    return n;
}

TEST_F(Batch, TheExampleRunsAsShipped)
{
    const std::string out = folder_ / "example";
    const auto result =
        runProgram("mono-slam-batch", "'" + (sourceFolder() / "config/batch_example.ini").string() +
                                          "' --output '" + out + "'");
    EXPECT_EQ(result.status, 0) << result.output;
    const std::string csv = results("example");
    EXPECT_EQ(count(csv, ",done,0,"), 16U) << csv;
    EXPECT_NE(csv.find(",SE3_ate_rmse_mm,"), std::string::npos);
    EXPECT_NE(csv.find(",run_path_length,"), std::string::npos);
}

TEST_F(Batch, ASecondCallRunsNothing)
{
    ASSERT_EQ(batch().status, 0);
    const auto before = records(folder_ / "out");
    const std::string csv = results();
    EXPECT_EQ(before.size(), 4U);
    ASSERT_EQ(batch().status, 0);
    EXPECT_EQ(records(folder_ / "out"), before);
    EXPECT_EQ(results(), csv);
}

TEST_F(Batch, AChangedConfigurationRunsOnlyWhatChanged)
{
    ASSERT_EQ(batch().status, 0);
    const auto before = records(folder_ / "out");
    writeBatch("strategies = spatial_nn jcbb\nseeds = 1-2\n");
    ASSERT_EQ(batch().status, 0);
    auto after = records(folder_ / "out");
    EXPECT_EQ(after.size(), 8U);
    for (const auto& [file, time] : before) EXPECT_EQ(after.at(file), time) << file;

    writeBatch("strategies = spatial_nn jcbb\nseeds = 1-2\n",
               "[variant.v]\nstrategies = jcbb\nmap.strikes = 4\n[variant.default]\n");
    ASSERT_EQ(batch().status, 0);
    EXPECT_EQ(records(folder_ / "out").size(), 12U);
    writeText(folder_ / "base.ini", "[map]\nstrikes = 5\n");
    ASSERT_EQ(batch().status, 0);
    EXPECT_EQ(records(folder_ / "out").size(), 24U);
    EXPECT_EQ(count(results(), ",done,0,"), 12U);
}

TEST_F(Batch, AJobThatFailsIsRecordedAndTheOthersRun)
{
    const std::string image = folder_ / "b_Images/000007.png";
    fs::rename(image, folder_ / "taken.png");
    const auto result = batch();
    EXPECT_EQ(result.status, 1) << result.output;
    EXPECT_EQ(count(results(), ",done,0,"), 2U);
    EXPECT_EQ(count(results(), ",failed,1,"), 2U);
    EXPECT_GE(count(results(), "000007.png"), 2U) << results();

    const auto before = records(folder_ / "out");
    EXPECT_EQ(batch().status, 1);
    EXPECT_EQ(records(folder_ / "out"), before);
    fs::rename(folder_ / "taken.png", image);
    EXPECT_EQ(batch("--retry-failed").status, 0);
    EXPECT_EQ(count(results(), ",done,0,"), 4U);
    for (const auto& [file, time] : records(folder_ / "out"))
        EXPECT_EQ(time == before.at(file), file.find("/all.a/") != std::string::npos) << file;
}

TEST_F(Batch, TheListGivesTheSameResults)
{
    ASSERT_EQ(batch().status, 0);
    const auto list = batch("--list --output '" + (folder_ / "two words") + "'");
    EXPECT_EQ(list.status, 0);
    EXPECT_EQ(std::count(list.output.begin(), list.output.end(), '\n'), 4);
    writeText(folder_ / "list.sh", list.output);
    const auto ran = runShell("sh -e '" + (folder_ / "list.sh") + "'");
    ASSERT_EQ(ran.status, 0) << ran.output;
    EXPECT_EQ(batch("--collect --output '" + (folder_ / "two words") + "'").status, 0);
    EXPECT_EQ(withoutTimes(results("two words")), withoutTimes(results()));
}

/** Sends a signal as soon as a job has ended. */
ProgramResult stopped(const std::string& ini, const std::string& out, const std::string& signal)
{
    return runShell(quotedProgram("mono-slam-batch") + " '" + ini + "' --jobs 1 & p=$!; until " +
                    "find '" + out + "' -name job.json | grep -q . || ! kill -0 $p; do sleep " +
                    "0.01; done 2>/dev/null; kill -" + signal + " $p; wait $p; s=$?; sleep 0.2; " +
                    "pgrep -f -- '--outpu[t] " + out + "/jobs' && echo ORPHAN; exit $s");
}

TEST_F(Batch, CtrlCEndsTheProgramsAndKeepsTheResults)
{
    const auto result = stopped(ini_, folder_ / "out", "INT");
    EXPECT_EQ(result.status, 130) << result.output;
    EXPECT_EQ(result.output.find("ORPHAN"), std::string::npos) << result.output;
    EXPECT_GE(count(results(), ",done,0,"), 1U);
    EXPECT_GE(count(results(), ",pending,"), 1U);
    EXPECT_EQ(count(results(), ",failed,"), 0U);
}

TEST_F(Batch, KilledItGoesOnWhereItWas)
{
    const auto result = stopped(ini_, folder_ / "out", "KILL");
    EXPECT_EQ(result.status, 137) << result.output;
    EXPECT_EQ(result.output.find("ORPHAN"), std::string::npos) << result.output;
    const auto before = records(folder_ / "out");
    EXPECT_GE(before.size(), 1U);
    EXPECT_LT(before.size(), 4U);
    ASSERT_EQ(batch().status, 0);
    const auto after = records(folder_ / "out");
    for (const auto& [file, time] : before) EXPECT_EQ(after.at(file), time) << file;
    ASSERT_EQ(batch("--output '" + (folder_ / "undisturbed") + "'").status, 0);
    EXPECT_EQ(withoutTimes(results()), withoutTimes(results("undisturbed")));
}
}  // namespace
}  // namespace monoslam
