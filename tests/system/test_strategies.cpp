// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "appRuns.h"

namespace monoslam
{
namespace
{
const std::string kShort = " --set rawlog.frame_count=40";

std::string strategy(const std::string& name)
{
    return " --set association.strategy=" + name;
}

/** A column of a CSV file of ours that has no commas in quotes before it. */
std::vector<double> column(const std::string& file, const std::string& name)
{
    std::istringstream text(readText(file));
    std::string line;
    std::vector<double> values;
    long index = -1;
    while (std::getline(text, line))
    {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
        if (index < 0)
            index = std::find(cells.begin(), cells.end(), name) - cells.begin();
        else
            values.push_back(std::stod(cells.at(static_cast<std::size_t>(index))));
    }
    return values;
}
}  // namespace

TEST(Strategies, EveryOneFollowsTheShippedSequence)
{
    const TemporaryFolder folder;
    const auto listed = runProgram("mono-slam", "--list-strategies");
    ASSERT_EQ(listed.status, 0);
    std::istringstream table(listed.output);
    int strategies = 0;
    for (std::string line; std::getline(table, line);)
    {
        const std::string name = line.substr(2, line.find(' ', 2) - 2);
        if (line.rfind("|---", 0) == 0 || name == "strategy") continue;
        ++strategies;
        const std::string output = folder / name;
        run(kDesk + kShort + strategy(name), output);
        evaluate(shipped("datasets/desk/groundtruth.txt"), output);
        EXPECT_LT(figure(output + "/figures.json", "SE3_ate_rmse_mm"), 30.0) << name;
        EXPECT_EQ(figure(output + "/figures.json", "frames_lost"), 0.0) << name;
    }
    EXPECT_EQ(strategies, 14);
    EXPECT_EQ(readText(folder / "none/trajectory.tum"),
              readText(folder / "appearance_nn/trajectory.tum"));
    for (const std::string name : {"jcbb", "hohct", "ccda"})
        EXPECT_LT(figure(folder / (name + "/figures.json"), "SE3_ate_rmse_mm"), 5.0) << name;
}

TEST(Strategies, MhdaGivesTheSameBitsOnAnyNumberOfThreadsAndReportsItsBeliefs)
{
    const TemporaryFolder folder;
    const std::string four = kDesk + kShort + strategy("mhda") +
                             " --set association.mhda.particles=4 --set association.mhda.threads=";
    run(four + "1", folder / "serial");
    run(four + "3", folder / "parallel");
    run(four + "1 --seed 2", folder / "other");
    for (const std::string file : {"/trajectory.tum", "/covariance.csv", "/map.csv"})
    {
        EXPECT_EQ(readText(folder / ("serial" + file)), readText(folder / ("parallel" + file)));
        EXPECT_NE(readText(folder / ("serial" + file)), readText(folder / ("other" + file)));
    }
    const std::string frames = folder / "serial/frames.csv";
    const auto beliefs = column(frames, "beliefs"), effective = column(frames, "effective_beliefs");
    const auto distance = column(frames, "belief_distance");
    const auto ages = column(frames, "ancestor_age_frames");
    ASSERT_EQ(beliefs.size(), 40);
    double farthest = 0.0;
    for (std::size_t i = 1; i < beliefs.size(); ++i)
    {
        EXPECT_EQ(beliefs[i], 4.0);
        EXPECT_GE(effective[i], 1.0);
        EXPECT_LE(effective[i], 4.0 + 1e-9);
        EXPECT_GE(ages[i], 1.0);
        EXPECT_LE(ages[i], ages[i - 1] + 1.0);
        farthest = std::max(farthest, distance[i]);
    }
    EXPECT_GT(farthest, 0.0);
}

/** Where the camera is fast, ellipses are wide and hold much that looks like a landmark. */
TEST(Strategies, WrongFirstPairsOfAFrameDoNotCarryTheCameraAway)
{
    const TemporaryFolder folder;
    int contradicted = 0;
    for (const std::string seed : {"1", "2", "3", "4", "5", "6"})
    {
        const std::string output = folder / seed;
        run(kDesk + " --set rawlog.frame_count=130 --seed " + seed + strategy("active_search"),
            output);
        evaluate(shipped("datasets/desk/groundtruth.txt"), output);
        EXPECT_LT(figure(output + "/figures.json", "SE3_ate_rmse_mm"), 5.0) << seed;
        const std::string frames = readText(output + "/frames.csv");
        contradicted += frames.find("matches contradicted") != std::string::npos ? 1 : 0;
    }
    EXPECT_GT(contradicted, 0);
}

TEST(Strategies, SecondPapersSettingsFollowTheShippedSequence)
{
    const TemporaryFolder folder;
    run(quoted(shipped("config/soto2013.ini")) + " " +
            quoted(shipped("datasets/desk/desk.rawlog")) + kShort +
            " --set metric_start.method=rectangle --set 'metric_start.rectangle_size_m=0.21 "
            "0.1485'",
        folder / "out");
    evaluate(shipped("datasets/desk/groundtruth.txt"), folder / "out");
    EXPECT_EQ(figure(folder / "out/figures.json", "frames_lost"), 0.0);
}

TEST(Strategies, MrptsJcbbIsEndedAtItsCapAndTheReportSaysSo)
{
    const TemporaryFolder folder;
    const std::string jcbb = kDesk + kShort + strategy("jcbb_mrpt") +
                             " --set association.jcbb_mrpt.max_candidates=5"
                             " --set association.jcbb_mrpt.time_cap_s=";
    run(jcbb + "0.0001", folder / "capped");
    run(jcbb + "100", folder / "whole");
    const std::string frames = folder / "capped/frames.csv";
    const auto capped = column(frames, "capped"), proved = column(frames, "proved");
    double all = 0.0;
    for (std::size_t i = 0; i < capped.size(); ++i)
    {
        EXPECT_EQ(proved[i], capped[i] > 0.0 ? 0.0 : 1.0) << i;
        all += capped[i];
    }
    EXPECT_GT(all, 10.0);
    EXPECT_EQ(figure(folder / "capped/summary.json", "capped"), all);
    EXPECT_GT(figure(folder / "capped/summary.json", "frames_not_proved"), 0.0);
    EXPECT_EQ(figure(folder / "whole/summary.json", "capped"), 0.0);
}

TEST(Strategies, RefuseMrptsFilterWhereTheyCorrectPixelByPixel)
{
    const TemporaryFolder folder;
    for (const std::string name : {"active_search", "mhda"})
    {
        const auto result =
            runProgram("mono-slam", kDesk + strategy(name) + " --set filter.engine=mrpt" +
                                        " --dry-run --output " + quoted(folder / "out"));
        EXPECT_EQ(result.status, 1);
        EXPECT_NE(result.output.find("[filter] engine = mrpt"), std::string::npos) << result.output;
        EXPECT_NE(result.output.find(name), std::string::npos) << result.output;
    }
}
}  // namespace monoslam
