// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "appRuns.h"
#include "monoslam_mrpt/readFeatureRawlog.h"

namespace monoslam
{
namespace
{
/** mono-slam-sim on the shipped options, 20 frames. */
class Simulator : public testing::Test
{
   protected:
    [[nodiscard]] ProgramResult write(const std::string& more = {}) const
    {
        return sim(" --output " + quoted(rawlog_) + " --set simulation.frames=20 " + more);
    }

    [[nodiscard]] ProgramResult runOn(const std::string& rawlog, const std::string& output,
                                      const std::string& more = {}) const
    {
        return sim(" --run " + quoted(rawlog) + " --output " + quoted(output) + " " + more);
    }

    [[nodiscard]] ProgramResult sim(const std::string& arguments) const
    {
        return runProgram("mono-slam-sim", quoted(ini_) + arguments);
    }

    /** Exit status 1 and one line that holds all the words. */
    static void expectOneLine(const ProgramResult& result, const std::vector<std::string>& words)
    {
        EXPECT_EQ(result.status, 1) << result.output;
        EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
        EXPECT_EQ(result.output.rfind("mono-slam-sim: ", 0), 0u) << result.output;
        for (const auto& word : words)
            EXPECT_NE(result.output.find(word), std::string::npos)
                << word << " not in: " << result.output;
    }

    TemporaryFolder folder_;
    std::string ini_ = shipped("config/simulation.ini");
    std::string rawlog_ = folder_ / "a.rawlog";
};
}  // namespace

TEST_F(Simulator, WritesTheSameFilesForASeedAndOthersForAnother)
{
    ASSERT_EQ(write("--seed 3").status, 0);
    const std::string rawlog = readText(rawlog_), truth = readText(folder_ / "a.tum");
    EXPECT_EQ(std::count(truth.begin(), truth.end(), '\n'), 20);
    EXPECT_EQ(readFeatureRawlog(rawlog_).frames.size(), 20);
    ASSERT_EQ(write("--seed 3 --force").status, 0);
    EXPECT_EQ(readText(rawlog_), rawlog);
    EXPECT_EQ(readText(folder_ / "a.tum"), truth);
    ASSERT_EQ(write("--seed 4 --force").status, 0);
    EXPECT_NE(readText(rawlog_), rawlog);
}

TEST_F(Simulator, RunsAnyStrategyOnWhatItWrote)
{
    ASSERT_EQ(write().status, 0);
    for (const std::string strategy : {"hohct", "mhda", "jcbb_mrpt"})
    {
        const std::string out = folder_ / strategy;
        const auto result = runOn(rawlog_, out, "--set association.strategy=" + strategy);
        ASSERT_EQ(result.status, 0) << result.output;
        EXPECT_NE(result.output.find("20 frames"), std::string::npos);
        evaluate(folder_ / "a.tum", out);
        EXPECT_LT(figure(out + "/figures.json", "SE3_ate_rmse_mm"), 50.0) << strategy;
    }
    ASSERT_EQ(runOn(rawlog_, folder_ / "again").status, 0);
    EXPECT_EQ(readText(folder_ / "again/trajectory.tum"),
              readText(folder_ / "hohct/trajectory.tum"));
}

TEST_F(Simulator, WritesItsDefaultOptions)
{
    const std::string file = folder_ / "written.ini";
    const std::string arguments = "--write-default-config " + quoted(file);
    ASSERT_EQ(runProgram("mono-slam-sim", arguments).status, 0);
    EXPECT_EQ(readText(file), readText(ini_));
    expectOneLine(runProgram("mono-slam-sim", arguments), {"written.ini", "--force"});
    // An empty file but for the camera means the same.
    ASSERT_EQ(write().status, 0);
    const std::string rawlog = readText(rawlog_);
    ini_ = folder_ / "least.ini";
    writeText(ini_,
              "[camera]\nsource = ini\nwidth_px = 640\nheight_px = 480\nfx_px = 500\nfy_px = 500\n"
              "cx_px = 319.5\ncy_px = 239.5\n");
    ASSERT_EQ(write("--force").status, 0);
    EXPECT_EQ(readText(rawlog_), rawlog);
}

TEST_F(Simulator, NamesWhatIsWrongWithTheOptions)
{
    expectOneLine(write("--set simulation.frame=3"), {"[simulation]", "frame"});
    expectOneLine(write("--set wrong_matches.kind=other"), {"[wrong_matches]", "kind", "other"});
    expectOneLine(write("--set wrong_matches.landmarks=500"), {"[wrong_matches]", "500", "view"});
    expectOneLine(write("--set simulator.frames=3"), {"unknown section [simulator]"});
    expectOneLine(write("--set association.jcbb.tua=0.9"), {"[association.jcbb]", "tua"});
    expectOneLine(write("--set camera.source=rawlog"), {"[camera]", "source"});
    expectOneLine(runProgram("mono-slam-sim", "--output x.rawlog"), {"no CONFIG.ini"});
    expectOneLine(sim(""), {"no --output"});
    ini_ = folder_ / "none.ini";
    expectOneLine(write(), {"none.ini", "no such"});
    EXPECT_FALSE(std::filesystem::exists(rawlog_));
}

TEST_F(Simulator, ReplacesNothingUnasked)
{
    ASSERT_EQ(write().status, 0);
    const std::string rawlog = readText(rawlog_);
    expectOneLine(write("--seed 2"), {"exists", "--force"});
    std::filesystem::remove(rawlog_);
    expectOneLine(write("--seed 2"), {"a.tum", "exists", "--force"});
    EXPECT_FALSE(std::filesystem::exists(rawlog_));
    ASSERT_EQ(write("--force").status, 0);
    EXPECT_EQ(readText(rawlog_), rawlog);
    writeText(folder_ / "out/mine.txt", "kept");
    expectOneLine(runOn(rawlog_, folder_ / "out"), {"out", "--force"});
    ASSERT_EQ(runOn(rawlog_, folder_ / "out", "--force").status, 0);
    EXPECT_EQ(readText(folder_ / "out/mine.txt"), "kept");
}

TEST_F(Simulator, NamesWhatItCannotReadOrWrite)
{
    rawlog_ = folder_ / "missing/a.rawlog";
    expectOneLine(write(), {"missing/a.rawlog", "cannot be written"});
    rawlog_ = folder_ / "a.txt";
    expectOneLine(write(), {"a.txt", "must end in .rawlog"});
    expectOneLine(runOn(folder_ / "none.rawlog", folder_ / "out"), {"none.rawlog", "no such"});
    expectOneLine(runOn(shipped("datasets/README.md"), folder_ / "out"), {"README.md", "rawlog"});
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}
}  // namespace monoslam
