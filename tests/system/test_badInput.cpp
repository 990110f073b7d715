// SPDX-License-Identifier: BSD-3-Clause
#include "SpoiledRun.h"

namespace monoslam
{
namespace
{
namespace fs = std::filesystem;
using BadInput = SpoiledRun;

TEST_F(BadInput, MissingIni)
{
    fs::remove(ini_);
    expectOneLine(run(), {"run.ini", "no such"});
}

TEST_F(BadInput, UnknownSection)
{
    expectOneLine(run("--set mapp.strikes=3"), {"run.ini", "[mapp]"});
}

TEST_F(BadInput, UnknownKeys)
{
    expectOneLine(run("--set map.strike=3"), {"run.ini", "[map]", "strike"});
    expectOneLine(run("--set rawlog.first=3"), {"[rawlog]", "first"});
    expectOneLine(run("--set association.jcbb.tua=0.9"), {"[association.jcbb]", "tua"});
}

TEST_F(BadInput, WrongType)
{
    expectOneLine(run("--set rawlog.every_nth=two"), {"[rawlog]", "every_nth", "two"});
    expectOneLine(run("--set filter.engine=other"), {"[filter]", "engine", "other"});
    expectOneLine(run("--set association.strategy=guess"), {"[association]", "guess", "hohct"});
}

TEST_F(BadInput, ValueOutOfRange)
{
    expectOneLine(run("--set rawlog.every_nth=0"), {"[rawlog]", "every_nth", "0"});
    expectOneLine(run("--set rawlog.first_frame=99"), {"first_frame = 99", "30 images"});
    expectOneLine(run("--set search.patch_px=12"), {"[search]", "patch_px", "12"});
    expectOneLine(run("--set motion.sigma_accel_mps2=-1"), {"[motion]", "sigma_accel_mps2", "-1"});
}

TEST_F(BadInput, SettingWithoutADotOrAnEqualsSign)
{
    expectOneLine(run("--set strikes=3"), {"--set", "section.key=value"});
    expectOneLine(run("--set map.strikes"), {"--set", "section.key=value"});
}

TEST_F(BadInput, OutputInUse)
{
    writeText(out_ + "/precious.txt", "mine");
    expectOneLine(run(), {"out", "not empty", "--force"});
    EXPECT_EQ(run("--force").status, 0);
    EXPECT_EQ(readText(out_ + "/precious.txt"), "mine");
}

TEST_F(BadInput, OutputThatCannotBeWritten)
{
    writeText(folder_ / "file", "");
    out_ = folder_ / "file/out";
    expectOneLine(run(), {"file/out"});
    out_ = "/proc/nowhere";
    expectOneLine(run(), {"/proc/nowhere"});
}

TEST_F(BadInput, FullDisk)
{
    for (const std::string name :
         {"trajectory.tum", "covariance.csv", "frames.csv", "groundtruth.tum", "map.csv", "map.ply",
          "map.3Dscene", "summary.json", "pictures/frame_000000.jpg", "top_view.png"})
    {
        fs::remove_all(out_);
        fs::create_directories(out_ + "/pictures");
        fs::create_symlink("/dev/full", out_ + "/" + name);
        expectOneLine(run("--force --pictures --set rawlog.frame_count=3"),
                      {name, "cannot be written"});
    }
    expectOneLine(run("--force --robot-path /dev/full"), {"/dev/full", "cannot be written"});
}

/** A disk that fills up in the midst of the run: no file may grow beyond four kilobytes. */
TEST_F(BadInput, FullDiskInTheMidstOfTheRunKeepsTheResultsSoFar)
{
    expectOneLine(run({}, "trap '' XFSZ; ulimit -f 8;"), {"cannot be written"});
    const std::string frames = readText(out_ + "/frames.csv");
    EXPECT_LE(frames.size(), 4096U);
    EXPECT_GT(std::count(frames.begin(), frames.end(), '\n'), 5);
    for (const char* name : {"trajectory.tum", "covariance.csv", "frames.csv"})
        expectCompleteTable(name);
}

TEST_F(BadInput, InterruptLeavesCompleteOutputs)
{
    rewriteWith(exampleTimes(110));
    const std::string started = "[ \"$(cat '" + out_ + "/frames.csv' | wc -l)\" -gt 5 ]";
    const auto result = runShell(quotedProgram("mono-slam") + " '" + ini_ + "' --output '" + out_ +
                                 "' --pictures & p=$!; until " + started +
                                 " || ! kill -0 $p; do sleep 0.01; done; kill -INT $p; wait $p");
    if (result.status == 0) GTEST_SKIP() << "the run was over before the signal";
    EXPECT_EQ(result.status, 130) << result.output;
    expectResultsSoFar();
    EXPECT_GT(linesOf("frames.csv"), 5);
}
}  // namespace
}  // namespace monoslam
