// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/RangeBearingKFSLAM.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/opengl/CSetOfObjects.h>

#include "monoslam_mrpt/RangeBearingMhda.h"
#include "rangeBearingWorld.h"

namespace monoslam::test
{
namespace
{
using mrpt::config::CConfigFileMemory;
using mrpt::math::TPoint3D;

const std::vector<TPoint3D> kLandmarks = {
    {5.0, 1.0, 0.5}, {6.0, -2.0, -0.5}, {8.0, 0.5, 1.0}, {4.0, 3.0, 0.0}, {9.0, -3.0, 1.5}};

CConfigFileMemory ini(const std::string& method, const std::string& more = {})
{
    return CConfigFileMemory(
        "[RangeBearingKFSLAM]\nstd_sensor_range = 0.05 // [m]\n"
        "std_sensor_yaw_deg = 0.5\nstd_sensor_pitch_deg = 0.5\n"
        "data_assoc_method = " +
        method + "\n" + more);
}

std::string messageOf(const std::function<void()>& action)
{
    try
    {
        action();
    }
    catch (const std::exception& e)
    {
        return e.what();
    }
    return "no exception";
}

class EveryMethod : public testing::TestWithParam<const char*>
{
};
}  // namespace

TEST_P(EveryMethod, FollowsTheRobotAndMapsEveryLandmarkOnce)
{
    RangeBearingWorld world(kLandmarks);
    RangeBearingKFSLAM slam;
    slam.loadOptions(ini(GetParam()));
    for (int step = 0; step < 30; ++step)
    {
        world.move(0.05);
        world.step(slam);
    }
    EXPECT_EQ(slam.getNumberOfLandmarksInTheMap(), kLandmarks.size());
    EXPECT_EQ(slam.getLastDataAssociation().results.associations.size(), kLandmarks.size());
    EXPECT_LT(world.distanceFrom(slam.getCurrentRobotPoseMean()), 0.06);
    auto objects = mrpt::opengl::CSetOfObjects::Create();
    slam.getAs3DObject(objects);
    EXPECT_GT(objects->size(), kLandmarks.size());
}

INSTANTIATE_TEST_SUITE_P(All, EveryMethod,
                         testing::Values("NN", "JCBB", "HOHCT", "assocJCBB", "NN_MRPT",
                                         "JCBB_MRPT"));

TEST(RangeBearingKFSLAM, TakesMrptsOptionsWhenTheIniNamesNoMethod)
{
    RangeBearingKFSLAM slam;
    EXPECT_EQ(slam.method(), assocNN);
    slam.options.data_assoc_method = mrpt::slam::assocJCBB;
    EXPECT_EQ(slam.method(), assocJCBB);
    slam.loadOptions(ini("HOHCT"));
    EXPECT_EQ(slam.method(), assocHOHCT);
    EXPECT_FLOAT_EQ(slam.options.std_sensor_range, 0.05F);
}

TEST(RangeBearingKFSLAM, NamesWhatIsWrongWithAnIni)
{
    RangeBearingKFSLAM slam;
    const std::string method = messageOf([&] { slam.loadOptions(ini("JCB")); });
    EXPECT_NE(method.find("data_assoc_method = JCB"), std::string::npos) << method;
    EXPECT_NE(method.find("HOHCT"), std::string::npos) << method;
    EXPECT_NE(messageOf([&] { slam.loadOptions(ini("17")); }).find("= 17"), std::string::npos);
    const std::string key =
        messageOf([&] { slam.loadOptions(ini("NN", "[RangeBearingKFSLAM_Joint]\ncap = 1")); });
    EXPECT_NE(key.find("[RangeBearingKFSLAM_Joint]"), std::string::npos) << key;
    RangeBearingWorld world(kLandmarks);
    slam.loadOptions(ini("MHDA"));
    world.step(slam);
    EXPECT_NE(messageOf([&] { world.step(slam); }).find("RangeBearingMhda"), std::string::npos);
}

TEST(RangeBearingKFSLAM, TrustsIdsAndNeverGivesTheirLandmarkToAnother)
{
    RangeBearingWorld world(kLandmarks);
    RangeBearingKFSLAM slam;
    slam.loadOptions(ini("NN"));
    auto named = world.observe();
    for (std::size_t i = 0; i < kLandmarks.size(); ++i)
        named->sensedData[i].landmarkID = static_cast<int>(10 + i);
    world.step(slam, named);
    auto again = world.observe();
    again->sensedData.push_back(world.measure(kLandmarks[2], 12));
    again->sensedData.erase(again->sensedData.begin() + 1);
    world.step(slam, again);
    const auto& results = slam.getLastDataAssociation().results.associations;
    EXPECT_EQ(results.count(1), 0U) << "the same landmark without its ID";
    EXPECT_EQ(results.at(0), 0U);
    EXPECT_EQ(slam.getNumberOfLandmarksInTheMap(), kLandmarks.size());
}

TEST(RangeBearingKFSLAM, ForgetsClutterAndKeepsItsNumbersInOrder)
{
    RangeBearingWorld world(kLandmarks);
    RangeBearingKFSLAM slam, keeping;
    slam.loadOptions(ini("HOHCT"));
    keeping.loadOptions(ini("HOHCT", "[RangeBearingKFSLAM_Joint]\nremove_missed = false"));
    for (int step = 0; step < 20; ++step)
    {
        world.move(0.05);
        auto sensor = world.observe();
        const TPoint3D clutter{7.0, -6.0 + 0.6 * step, -2.0};
        sensor->sensedData.insert(sensor->sensedData.begin(), world.measure(clutter));
        world.step(slam, sensor);
        world.step(keeping, sensor);
    }
    EXPECT_EQ(keeping.getNumberOfLandmarksInTheMap(), kLandmarks.size() + 20);
    EXPECT_EQ(slam.getNumberOfLandmarksInTheMap(), kLandmarks.size() + 1);
    EXPECT_EQ(slam.counters().removed, 19);
    EXPECT_EQ(slam.presence().count(), kLandmarks.size() + 1);
    EXPECT_EQ(slam.presence().serial(kLandmarks.size()), kLandmarks.size() + 19);
    EXPECT_LT(world.distanceFrom(slam.getCurrentRobotPoseMean()), 0.06);
}

TEST(RangeBearingKFSLAM, ForgetsWhatIsSeenOnceAtTheBorderOfTheView)
{
    // Nobody can tell whether it should have been seen again; if it stays, it takes what its
    // neighbours measure.
    RangeBearingWorld world(kLandmarks);
    RangeBearingKFSLAM slam;
    slam.loadOptions(ini("HOHCT"));
    const double border_rad = 0.97;
    for (int step = 0; step < 2; ++step)
    {
        auto sensor = world.observe();
        sensor->fieldOfView_yaw = 2.0F;
        if (step == 0)
            sensor->sensedData.push_back(
                world.measure({5.0 * std::cos(border_rad), 5.0 * std::sin(border_rad), 0.0}));
        world.step(slam, sensor);
    }
    EXPECT_EQ(slam.getNumberOfLandmarksInTheMap(), kLandmarks.size());
    EXPECT_EQ(slam.counters().removed, 1);
}

TEST(LandmarkPresence, DoubtsWhatIsMissedMoreOftenThanSeen)
{
    LandmarkPresence presence;
    for (int i = 0; i < 3; ++i) presence.born();
    EXPECT_TRUE(presence.isNewborn(1));
    for (int i = 0; i < 10; ++i) presence.seen(1, 0.9);
    EXPECT_FALSE(presence.isNewborn(1));
    presence.missed(0, 0.9);
    EXPECT_EQ(presence.absent(), std::vector<std::size_t>{0});
    presence.erase({0});
    EXPECT_EQ(presence.serial(0), 1U);
    presence.missed(0, 0.9);
    presence.missed(0, 0.9);
    EXPECT_TRUE(presence.absent().empty());
    presence.missed(0, 0.9);
    EXPECT_EQ(presence.absent(), std::vector<std::size_t>{0});
    presence.born();
    EXPECT_EQ(presence.serial(2), 3U);
}

TEST(RangeBearingMhda, FollowsTheRobotAndRepeatsItsBits)
{
    for (const char* resampling : {"multinomial", "systematic", "neff"})
    {
        std::vector<mrpt::poses::CPose3DQuat> ends;
        for (int run = 0; run < 2; ++run)
        {
            RangeBearingWorld world(kLandmarks);
            RangeBearingMhda<RangeBearingKFSLAM> slam(3);
            slam.loadOptions(ini("MHDA", std::string("[RangeBearingKFSLAM_MHDA]\nparticles = 3\n"
                                                     "resampling = ") +
                                             resampling));
            for (int step = 0; step < 30; ++step)
            {
                world.move(0.05);
                world.step(slam);
            }
            EXPECT_EQ(slam.best().getNumberOfLandmarksInTheMap(), kLandmarks.size());
            EXPECT_EQ(slam.weights().size(), 3U);
            ends.push_back(slam.best().getCurrentRobotPoseMean());
            EXPECT_LT(world.distanceFrom(ends.back()), 0.06);
        }
        EXPECT_EQ(ends[0].x(), ends[1].x());
        EXPECT_EQ(ends[0].y(), ends[1].y());
    }
}
}  // namespace monoslam::test
