// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>

#include "TemporaryFolder.h"
#include "exampleRawlog.h"
#include "kfSlamRuns.h"

namespace monoslam
{
namespace fs = std::filesystem;

TEST(KfSlamJointInput, SaysWhatIsWrong)
{
    const TemporaryFolder folder;
    const std::string rawlog = (folder / "images.rawlog"), ini = (folder / "kf.ini");
    writeExampleRawlog(rawlog, exampleTimes(3), true);
    const auto messageOf = [&](const std::string& content, const std::string& more = {})
    {
        writeText(ini, content);
        const auto result = kfSlamJoint("'" + ini + "' '" + rawlog + "' --force --output '" +
                                        (folder / "out") + "'" + more);
        EXPECT_EQ(result.status, 1) << result.output;
        return result.output;
    };
    const auto has = [](const std::string& text, const std::string& part)
    {
        return text.find(part) != std::string::npos ? testing::AssertionSuccess()
                                                    : testing::AssertionFailure() << text;
    };
    EXPECT_TRUE(has(messageOf(""), "no pairs of actions and observations"));
    EXPECT_TRUE(has(messageOf("[RangeBearing]\na = 1\n"), "[RangeBearing]"));
    EXPECT_TRUE(
        has(messageOf("[RangeBearingKFSLAM]\nstd_sensor_range = abc\n"), "std_sensor_range"));
    EXPECT_TRUE(has(messageOf("[RangeBearingKFSLAM]\ndata_assoc_method = JBCC\n"), "JBCC"));
    EXPECT_TRUE(has(messageOf("[RangeBearingKFSLAM_MHDA]\nparticles = 0\n"
                              "[RangeBearingKFSLAM]\ndata_assoc_method = MHDA\n"),
                    "particles"));
    EXPECT_TRUE(
        has(messageOf("[MappingApplication]\nground_truth_file_robot = none.txt\n"), "none.txt"));
    EXPECT_TRUE(has(messageOf("", setting("a=b")), "--set a=b"));
    writeText(rawlog, "no rawlog");
    EXPECT_TRUE(has(messageOf(""), "images.rawlog"));
}

TEST(KfSlamJointInput, NeverEmptiesAFolderOfOtherFiles)
{
    const TemporaryFolder folder;
    const std::string rawlog = (folder / "images.rawlog"), mine = (folder / "out/mine.txt");
    writeExampleRawlog(rawlog, exampleTimes(3), true);
    writeText(mine, "mine");
    writeText((folder / "out/robot_pose_00001.txt"), "old");
    writeText((folder / "kf.ini"), "");
    const std::string arguments =
        "'" + (folder / "kf.ini") + "' '" + rawlog + "' --output '" + (folder / "out") + "'";
    EXPECT_NE(kfSlamJoint(arguments).output.find("--force"), std::string::npos);
    EXPECT_TRUE(fs::exists((folder / "out/robot_pose_00001.txt")));
    static_cast<void>(kfSlamJoint(arguments + " --force"));
    EXPECT_FALSE(fs::exists((folder / "out/robot_pose_00001.txt")));
    EXPECT_TRUE(fs::exists(mine));
}
}  // namespace monoslam
