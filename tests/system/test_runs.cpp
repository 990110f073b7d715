// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "CsvFile.h"
#include "TemporaryFolder.h"
#include "appRuns.h"

namespace monoslam
{
namespace
{
std::string makeRawlog(const std::filesystem::path& sequence, const std::string& rawlog)
{
    const auto result =
        runProgram("images2rawlog", "--format tum --input " + quoted(sequence.string()) +
                                        " --camera " + quoted((sequence / "camera.yaml").string()) +
                                        " --output " + quoted(rawlog));
    EXPECT_EQ(result.status, 0) << result.output;
    return rawlog;
}

const std::string kShort = " --set rawlog.frame_count=40";
}  // namespace

TEST(Runs, ShippedSequenceIsMetricWithinThreeMillimetres)
{
    const TemporaryFolder folder;
    const std::string output = folder / "out";
    run(kDesk, output);
    evaluate(shipped("datasets/desk/groundtruth.txt"), output);
    EXPECT_LT(figure(output + "/figures.json", "SE3_ate_rmse_mm"), 3.0);
    EXPECT_NEAR(figure(output + "/figures.json", "scale"), 1.0, 0.01);
    EXPECT_EQ(figure(output + "/figures.json", "frames_lost"), 0.0);
}

/** The shipped depth pictures are those of every 40th frame; most landmarks are born near one. */
TEST(Runs, LandmarksOfTheShippedSequenceLieOnTheSurfaces)
{
    const TemporaryFolder folder;
    const std::string output = folder / "out", figures = folder / "figures.json";
    run(kDesk, output);
    const std::string truth = "--groundtruth " + quoted(shipped("datasets/desk/groundtruth.txt"));
    const std::string depth = " --depth " + quoted(shipped("datasets/desk/depth"));
    const auto judged =
        runProgram("mono-slam-eval", truth + depth + " --per-frame SE3 " + quoted(output) +
                                         " --json " + quoted(figures));
    ASSERT_EQ(judged.status, 0) << judged.output;
    EXPECT_GT(figure(figures, "landmark_count"), 30.0);
    EXPECT_LT(figure(figures, "none_landmark_median_m"), 0.01);
    EXPECT_LT(figure(figures, "none_landmark_relative_median_pct"), 1.0);

    CsvFile errors(output + "/errors.csv");
    double sum = 0.0;
    long poses = 0;
    for (; errors.next(); ++poses) sum += std::pow(errors.number("position_error_m"), 2);
    EXPECT_EQ(static_cast<double>(poses), figure(figures, "frames_matched"));
    EXPECT_NEAR(1000.0 * std::sqrt(sum / static_cast<double>(poses)),
                figure(figures, "SE3_ate_rmse_mm"), 1e-4);

    const auto refused = runProgram("mono-slam-eval", "--out-and-back" + depth + " " + output);
    EXPECT_NE(refused.status, 0);
    EXPECT_NE(refused.output.find("--groundtruth"), std::string::npos) << refused.output;
}

TEST(Runs, SameSeedGivesTheSameBitsAlsoOnOneCore)
{
    const TemporaryFolder folder;
    run(kDesk + kShort, folder / "a");
    run(kDesk + kShort, folder / "b");
    run(kDesk + kShort, folder / "c", "taskset -c 0");
    run(kDesk + kShort + " --seed 2", folder / "d");
    for (const std::string file : {"/trajectory.tum", "/covariance.csv", "/map.csv"})
    {
        const std::string first = readText(folder / ("a" + file));
        EXPECT_FALSE(first.empty()) << file;
        EXPECT_EQ(first, readText(folder / ("b" + file))) << file;
        EXPECT_EQ(first, readText(folder / ("c" + file))) << file;
        EXPECT_NE(first, readText(folder / ("d" + file))) << file;
    }
}

TEST(Runs, DefaultConfigurationSaysWhatTheProgramDoesAnyway)
{
    const TemporaryFolder folder;
    writeText(folder / "empty.ini", "[association]\n");
    const std::string rawlog = " " + quoted(shipped("datasets/desk/desk.rawlog")) + kShort;
    run(quoted(folder / "empty.ini") + rawlog, folder / "a");
    run(quoted(shipped("config/default.ini")) + rawlog, folder / "b");
    EXPECT_EQ(readText(folder / "a/trajectory.tum"), readText(folder / "b/trajectory.tum"));
    const auto written =
        runProgram("mono-slam", "--write-default-config " + quoted(folder / "written.ini"));
    ASSERT_EQ(written.status, 0) << written.output;
    EXPECT_EQ(readText(folder / "written.ini"), readText(shipped("config/default.ini")));
}

TEST(Runs, FirstPapersSettingsAndMrptsFilterFollowTheShippedSequence)
{
    const TemporaryFolder folder;
    const std::string target =
        " --set metric_start.method=rectangle --set 'metric_start.rectangle_size_m=0.21 0.1485'";
    const std::string rawlog = " " + quoted(shipped("datasets/desk/desk.rawlog"));
    const std::string paper = quoted(shipped("config/guerra2013.ini")) + rawlog + target + kShort;
    run(paper, folder / "paper");
    const std::string mrpt = quoted(shipped("config/default.ini")) + rawlog + kShort +
                             " --set filter.engine=mrpt --set initialization.covariance=paper"
                             " --set map.convert_linearity=0 --set start.parallax_deg=[]";
    run(mrpt, folder / "mrpt");
    for (const std::string name : {"paper", "mrpt"})
    {
        evaluate(shipped("datasets/desk/groundtruth.txt"), folder / name);
        EXPECT_EQ(figure(folder / (name + "/figures.json"), "frames_lost"), 0.0) << name;
    }
}

/** The lens is covered for a second: what the run says meanwhile, and that it comes back to its map. */
TEST(Runs, ACoveredLensIsSaidAndTheMapIsFoundAgain)
{
    const TemporaryFolder folder;
    const std::filesystem::path desk = shipped("datasets/desk");
    const std::filesystem::path copy = folder / "desk";
    std::filesystem::create_directory(copy);
    for (const char* name : {"camera.yaml", "groundtruth.txt", "rgb.txt", "desk_Images"})
        std::filesystem::copy(desk / name, copy / name, std::filesystem::copy_options::recursive);
    for (int k = 100; k < 130; ++k)
    {
        char name[40];
        std::snprintf(name, sizeof name, "desk_Images/%06d.jpg", k);
        writeText((copy / name).string(), "P5 640 480 255\n" + std::string(640 * 480, '\x1e'));
    }
    const std::string rawlog = quoted(makeRawlog(copy, folder / "covered.rawlog"));
    const auto covered = [&](const std::string& name, const std::string& more)
    {
        run(kDesk + " " + rawlog + more, folder / name);
        evaluate((copy / "groundtruth.txt").string(), folder / name);
        return figure(folder / (name + "/figures.json"), "none_ate_median_mm");
    };
    EXPECT_LT(covered("with", ""), 3.0);
    EXPECT_NE(readText(folder / "with/summary.json").find("back in the map that was lost"),
              std::string::npos);
    EXPECT_GE(figure(folder / "with/figures.json", "frames_lost"), 20.0);
    EXPECT_LE(figure(folder / "with/summary.json", "frames_degraded"), 15.0);
    CsvFile frames(folder / "with/frames.csv");
    for (long k = 0; frames.next(); ++k)
    {
        if (k < 105 || k >= 130) continue;
        EXPECT_EQ(frames.text("state"), "lost") << k;
    }

    EXPECT_GT(covered("without", " --set map.relocalize_every=0"), 10.0);
    EXPECT_GE(figure(folder / "without/summary.json", "frames_degraded"), 100.0);
}

TEST(Runs, RealChessboardSequenceIsMetric)
{
    const auto datasets = realDatasets();
    if (!datasets) GTEST_SKIP() << noRealDatasets;
    const TemporaryFolder folder;
    const auto sequence = *datasets / "chessboard_desk";
    const std::string rawlog = makeRawlog(sequence, folder / "board.rawlog");
    const std::string output = folder / "out";
    run(quoted(shipped("config/default.ini")) + " " + quoted(rawlog) +
            " --set metric_start.method=chessboard"
            " --set 'metric_start.chessboard_inner_corners=9 6'"
            " --set metric_start.chessboard_square_m=0.04",
        output);
    evaluate((sequence / "groundtruth.txt").string(), output);
    EXPECT_LT(figure(output + "/figures.json", "SE3_ate_rmse_mm"), 5.0);
    EXPECT_NEAR(figure(output + "/figures.json", "scale"), 1.0, 0.02);
}

TEST(Runs, LivingRoomSequenceWithoutATargetKeepsItsScale)
{
    const auto datasets = realDatasets();
    if (!datasets) GTEST_SKIP() << noRealDatasets;
    const TemporaryFolder folder;
    const auto sequence = *datasets / "living_room";
    const std::string rawlog = makeRawlog(sequence, folder / "room.rawlog");
    const std::string output = folder / "out";
    run(quoted(shipped("config/default.ini")) + " " + quoted(rawlog), output);
    evaluate((sequence / "groundtruth.txt").string(), output);
    EXPECT_LT(figure(output + "/figures.json", "Sim3_ate_rmse_mm"), 6.0);
    EXPECT_LT(std::abs(figure(output + "/figures.json", "scale_drift_pct")), 5.0);
}
}  // namespace monoslam
