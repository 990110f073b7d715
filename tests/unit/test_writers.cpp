// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/writers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "TemporaryFolder.h"
#include "monoslam_slam/RunSummary.h"

namespace monoslam
{
namespace
{
FrameReport reportAt(double t_s, TrackingState state = TrackingState::Tracking)
{
    FrameReport report;
    report.t_s = t_s;
    report.index = 7;
    report.state = state;
    report.x_v << 1, 2, 3, 0.5, 0.5, -0.5, 0.5, 0, 0, 0, 0, 0, 0;
    report.P_v.diagonal().setConstant(0.01);
    report.times.total_ms = 4.0;
    report.times.search_ms = 3.0;
    return report;
}

MapLandmark rayWith(double rho, double sigma)
{
    MapLandmark landmark;
    landmark.id = 3;
    landmark.y = Vector6d(Vector6d::Zero());
    landmark.y[5] = rho;
    landmark.P_y = 1e-6 * Eigen::MatrixXd::Identity(6, 6);
    landmark.P_y(5, 5) = sigma * sigma;
    return landmark;
}

std::vector<std::string> linesOf(const std::string& file)
{
    std::istringstream text(readText(file));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
}

long commasIn(const std::string& line)
{
    return std::count(line.begin(), line.end(), ',');
}

TEST(FrameWriters, KeepUnixTimesToTheTickAndPutTheScalarLast)
{
    TemporaryFolder folder;
    FrameWriters(folder.path()).write(reportAt(1305031229.528748));
    EXPECT_EQ(readText(folder / "trajectory.tum"), "1305031229.5287480 1 2 3 0.5 -0.5 0.5 0.5\n");
}

TEST(FrameWriters, WriteAPoseOnlyWhereThereIsOne)
{
    TemporaryFolder folder;
    FrameWriters writers(folder.path());
    writers.write(reportAt(0.1, TrackingState::Waiting));
    writers.write(reportAt(0.2, TrackingState::Lost));
    EXPECT_EQ(linesOf(folder / "trajectory.tum").size(), 1u);
    EXPECT_EQ(linesOf(folder / "covariance.csv").size(), 2u);
    EXPECT_EQ(linesOf(folder / "frames.csv").size(), 3u);
}

TEST(FrameWriters, WriteAsManyFieldsAsColumns)
{
    TemporaryFolder folder;
    FrameReport report = reportAt(0.1);
    report.remark = "said \"no\"";
    FrameWriters(folder.path()).write(report, 2.0);
    for (const char* name : {"covariance.csv", "frames.csv"})
    {
        const auto lines = linesOf(folder / name);
        EXPECT_EQ(commasIn(lines.at(0)), commasIn(lines.at(1))) << name;
    }
    EXPECT_EQ(commasIn(linesOf(folder / "covariance.csv").at(0)), 21);
    EXPECT_NE(readText(folder / "frames.csv").find("\"said \"\"no\"\"\""), std::string::npos);
}

TEST(FrameWriters, AreCompleteWhileTheRunGoesOn)
{
    TemporaryFolder folder;
    FrameWriters writers(folder.path());
    writers.write(reportAt(0.1));
    EXPECT_EQ(readText(folder / "trajectory.tum").back(), '\n');
}

TEST(FrameWriters, NameTheFileOnAFullDisk)
{
    TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/full", folder / "trajectory.tum");
    FrameWriters writers(folder.path());
    try
    {
        writers.write(reportAt(0.1));
        FAIL() << "a full disk went unnoticed";
    }
    catch (const std::runtime_error& e)
    {
        EXPECT_NE(std::string(e.what()).find("trajectory.tum"), std::string::npos) << e.what();
    }
}

TEST(PointOf, IsGivenOnlyWhereTheDepthIsFinite)
{
    EXPECT_TRUE(pointOf(rayWith(0.5, 0.1)));
    EXPECT_FALSE(pointOf(rayWith(0.5, 0.3)));
    EXPECT_FALSE(pointOf(rayWith(-0.5, 0.1)));
    EXPECT_NEAR(pointOf(rayWith(0.5, 0.1))->p.z(), 2.0, 1e-12);
}

TEST(WriteMap, LeavesThePointEmptyWhereItIsNotFinite)
{
    TemporaryFolder folder;
    writeMapCsv(folder.path(), {rayWith(0.5, 0.1), rayWith(0.5, 0.3)});
    writeMapPly(folder.path(), {rayWith(0.5, 0.1), rayWith(0.5, 0.3)});
    const auto lines = linesOf(folder / "map.csv");
    ASSERT_EQ(lines.size(), 3u);
    for (const auto& line : lines) EXPECT_EQ(commasIn(line), commasIn(lines[0]));
    EXPECT_NE(lines[2].find(",-1,0,0,0,,,,"), std::string::npos) << lines[2];
    EXPECT_NE(readText(folder / "map.ply").find("element vertex 1\n"), std::string::npos);
}

TEST(PrepareOutputFolder, RefusesAFolderInUse)
{
    TemporaryFolder folder;
    writeText(folder / "notes.txt", "mine");
    EXPECT_THROW(prepareOutputFolder(folder.path(), false), std::runtime_error);
}

TEST(PrepareOutputFolder, RemovesOnlyWhatWeWrite)
{
    TemporaryFolder folder;
    for (const char* name :
         {"notes.txt", "map.csv", "errors.csv", "pictures/frame_000001.jpg", "pictures/me.jpg"})
        writeText(folder / name, "x");
    prepareOutputFolder(folder.path(), true);
    EXPECT_TRUE(std::filesystem::exists(folder / "notes.txt"));
    EXPECT_TRUE(std::filesystem::exists(folder / "pictures/me.jpg"));
    EXPECT_FALSE(std::filesystem::exists(folder / "map.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder / "errors.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder / "pictures/frame_000001.jpg"));
}

TEST(RunSummary, CountsStatesAndShares)
{
    TemporaryFolder folder;
    RunSummary summary;
    summary.add(reportAt(0.1, TrackingState::Waiting));
    EXPECT_FALSE(summary.hasPose());
    summary.add(reportAt(0.2));
    summary.add(reportAt(0.3, TrackingState::Lost));
    RunFacts facts;
    facts.seed = 5;
    facts.config["map"]["strikes"] = "3";
    summary.write(folder.path(), facts);
    const auto json = nlohmann::json::parse(readText(folder / "summary.json"));
    EXPECT_TRUE(summary.hasPose());
    EXPECT_EQ(json["frames"], 3);
    EXPECT_EQ(json["frames_lost"], 1);
    EXPECT_EQ(json["frames_waiting"], 1);
    EXPECT_EQ(json["seed"], 5);
    EXPECT_EQ(json["config"]["map"]["strikes"], "3");
    EXPECT_DOUBLE_EQ(json["times"]["search"]["share"], 0.75);
    EXPECT_DOUBLE_EQ(json["times"]["total"]["median_ms"], 4.0);
}
}  // namespace
}  // namespace monoslam
