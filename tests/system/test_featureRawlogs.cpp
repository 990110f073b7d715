// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>

#include "TemporaryFolder.h"
#include "exampleRawlog.h"
#include "monoslam_eval/FeatureSlam.h"
#include "monoslam_eval/simulate.h"
#include "monoslam_mrpt/CObservationPixelFeatures.h"
#include "monoslam_mrpt/RawlogWriter.h"
#include "monoslam_mrpt/readFeatureRawlog.h"
#include "runProgram.h"

namespace monoslam
{
namespace
{
Simulation exampleWorld()
{
    SimulationOptions options;
    options.frames = 30;
    options.wrongMatches.landmarks = 4;
    options.wrongMatches.first_frame = 15;
    return simulate(options, 2);
}

Ticks ticksOfFrame(const PixelFrame& frame)
{
    return std::llround(frame.t_s * 1e7);
}

void writeWorld(const std::string& file, const Simulation& world)
{
    RawlogWriterOptions options;
    options.file = file;
    options.embed = true;
    options.camera = toTCamera(world.camera);
    RawlogWriter writer(options);
    for (const PixelFrame& frame : world.frames)
    {
        writer.addTruth(ticksOfFrame(frame), mrpt::poses::CPose3D(1, 2, 3));
        writer.addFeatures(ticksOfFrame(frame), frame.features);
    }
    writer.close();
}

void expectSame(const PixelFeature& a, const PixelFeature& b)
{
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.z, b.z);
    EXPECT_EQ(a.R, b.R);
    EXPECT_EQ(a.truth, b.truth);
    ASSERT_EQ(a.resembles.size(), b.resembles.size());
    for (std::size_t i = 0; i < a.resembles.size(); ++i)
    {
        EXPECT_EQ(a.resembles[i].landmark, b.resembles[i].landmark);
        EXPECT_EQ(a.resembles[i].score, b.resembles[i].score);
    }
}

CObservationPixelFeatures exampleObservation()
{
    CObservationPixelFeatures observation;
    observation.timestamp = clockOf(kExampleStart);
    observation.sensorLabel = "left";
    observation.cameraPose = mrpt::poses::CPose3D(0.1, 0.2, 0.3, 0.4, 0.5, 0.6);
    observation.cameraParams = toTCamera(exampleRawlogCamera());
    PixelFeature feature;
    feature.id = 7;
    feature.z = {12.5, 1.0 / 3.0};
    feature.R << 0.25, 0.01, 0.01, 0.36;
    feature.resembles = {{3, 0.91}, {5, 0.8}};
    observation.features = {feature, PixelFeature{}};
    observation.features[0].truth = 5;
    return observation;
}

/** What rawlog-edit --info says. */
ProgramResult info(const std::string& rawlog, const std::string& plugin = {})
{
    const std::string option = plugin.empty() ? "" : " -p '" + plugin + "'";
    return runShell("rawlog-edit --info -i '" + rawlog + "'" + option);
}

TEST(PixelFeaturesObservation, ComesBackFromAStreamAsItWas)
{
    const CObservationPixelFeatures written = exampleObservation();
    mrpt::io::CMemoryStream stream;
    auto archive = mrpt::serialization::archiveFrom(stream);
    archive << written;
    stream.Seek(0);
    const auto read = std::dynamic_pointer_cast<CObservationPixelFeatures>(archive.ReadObject());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->timestamp, written.timestamp);
    EXPECT_EQ(read->sensorLabel, "left");
    EXPECT_TRUE(read->cameraParams == written.cameraParams);
    mrpt::poses::CPose3D pose;
    read->getSensorPose(pose);
    EXPECT_LT((pose.asVectorVal() - written.cameraPose.asVectorVal()).norm(), 1e-12);
    ASSERT_EQ(read->features.size(), 2);
    for (std::size_t i = 0; i < 2; ++i) expectSame(read->features[i], written.features[i]);
}

TEST(PixelFeaturesObservation, SaysWhatItHolds)
{
    CObservationPixelFeatures observation = exampleObservation();
    const std::string text = observation.asString();
    for (const char* word : {"left", "2 features", "12.500", "5:0.800", "130"})
        EXPECT_NE(text.find(word), std::string::npos) << word << " not in:\n" << text;
    EXPECT_EQ(observation.exportTxtDataRow(),
              "2 7 12.5000 0.3333 0.5000 0.6000 5 -1 0.0000 0.0000 1.0000 1.0000 -2");
    observation.setSensorPose(mrpt::poses::CPose3D(4, 5, 6));
    EXPECT_EQ(observation.cameraPose.x(), 4.0);
}

TEST(FeatureRawlog, RunsAsTheWorldInMemoryDoesBitByBit)
{
    const TemporaryFolder folder;
    const Simulation world = exampleWorld();
    writeWorld(folder / "a.rawlog", world);
    const FeatureRawlog rawlog = readFeatureRawlog(folder / "a.rawlog");
    ASSERT_EQ(rawlog.frames.size(), world.frames.size());
    EXPECT_EQ(rawlog.groundTruth.size(), world.frames.size());
    for (const std::string strategy : {"hohct", "mhda"})
    {
        const mrpt::config::CConfigFileMemory ini;
        const std::shared_ptr<const Associator> associator = makeAssociator(strategy, ini);
        FeatureSlam inMemory({}, Camera(world.camera), associator, 1);
        FeatureSlam recorded({}, Camera(cameraFrom(rawlog.camera)), associator, 1);
        for (std::size_t i = 0; i < world.frames.size(); ++i)
        {
            const FeatureReport a = inMemory.process(world.frames[i]);
            const FeatureReport b = recorded.process(rawlog.frames[i]);
            EXPECT_EQ(a.t_s, b.t_s);
            EXPECT_EQ(a.x_v, b.x_v) << strategy << ", frame " << i;
            EXPECT_EQ(best(inMemory.mixture()).P, best(recorded.mixture()).P);
        }
    }
}

TEST(FeatureRawlog, IsReadByRawlogEditWithThePluginAndRefusedWithout)
{
    if (runShell("command -v rawlog-edit").status != 0) GTEST_SKIP() << "no rawlog-edit here";
    const std::string plugin =
        runShell("ls '" + programFolder().string() + "/../libs/libmonoslam_mrpt.so' 2>/dev/null")
            .output;
    if (plugin.empty()) GTEST_SKIP() << "a static build has no plugin";
    const TemporaryFolder folder;
    writeWorld(folder / "a.rawlog", exampleWorld());
    const ProgramResult without = info(folder / "a.rawlog");
    EXPECT_NE(without.output.find("monoslam::CObservationPixelFeatures"), std::string::npos);
    EXPECT_NE(without.output.find("not registered"), std::string::npos) << without.output;
    EXPECT_EQ(without.output.find("camera /"), std::string::npos) << without.output;
    const ProgramResult with = info(folder / "a.rawlog", plugin.substr(0, plugin.find('\n')));
    EXPECT_EQ(with.status, 0);
    EXPECT_EQ(with.output.find("not registered"), std::string::npos) << with.output;
    EXPECT_NE(with.output.find("camera /     30"), std::string::npos) << with.output;
}

TEST(FeatureRawlog, IsRefusedIfItHasNoFeaturesOrIsDamaged)
{
    const TemporaryFolder folder;
    const auto expectError = [](const std::string& file, const std::string& words)
    {
        try
        {
            static_cast<void>(readFeatureRawlog(file));
            ADD_FAILURE() << words;
        }
        catch (const std::runtime_error& error)
        {
            EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
        }
    };
    expectError(folder / "none.rawlog", "no such rawlog");
    writeExampleRawlog(folder / "images.rawlog", exampleTimes(3));
    expectError(folder / "images.rawlog", "no CObservationPixelFeatures");
    Simulation world = exampleWorld();
    world.frames[20].t_s = world.frames[19].t_s;
    writeWorld(folder / "twice.rawlog", world);
    expectError(folder / "twice.rawlog", "frame 20: its time is not after");
    writeWorld(folder / "cut.rawlog", exampleWorld());
    std::filesystem::resize_file(folder / "cut.rawlog",
                                 std::filesystem::file_size(folder / "cut.rawlog") / 2);
    expectError(folder / "cut.rawlog", "cut.rawlog: truncated or damaged");
}
}  // namespace
}  // namespace monoslam
