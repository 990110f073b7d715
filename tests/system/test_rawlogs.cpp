// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationStereoImages.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include "TemporaryFolder.h"
#include "exampleRawlog.h"
#include "monoslam_mrpt/RawlogReader.h"

namespace monoslam
{
namespace
{
RawlogOptions optionsFor(const std::string& file)
{
    RawlogOptions options;
    options.file = file;
    return options;
}

std::vector<Frame> readAll(RawlogReader& reader)
{
    std::vector<Frame> frames;
    while (auto frame = reader.next()) frames.push_back(std::move(*frame));
    return frames;
}

/** Objects one after another in an uncompressed rawlog. */
template <typename... Objects>
void writePlain(const std::string& file, const Objects&... objects)
{
    mrpt::io::CFileOutputStream stream(file);
    auto archive = mrpt::serialization::archiveFrom(stream);
    (static_cast<void>(archive << objects), ...);
}

mrpt::img::CImage imageWith(int index)
{
    return mrpt::img::CImage(exampleImage(index), mrpt::img::DEEP_COPY);
}

bool sameImage(const cv::Mat& a, const cv::Mat& b)
{
    return a.size() == b.size() && cv::countNonZero(a != b) == 0;
}

TEST(RawlogReader, GivesBackTimesPixelsCalibrationAndTruth)
{
    TemporaryFolder folder;
    for (const bool embed : {false, true})
    {
        const std::string file = folder / (embed ? "embedded.rawlog" : "external.rawlog");
        writeExampleRawlog(file, exampleTimes(5), embed);
        RawlogReader reader(optionsFor(file), {});
        EXPECT_EQ(reader.frameCount(), 5);
        EXPECT_EQ(reader.camera().fx_px, 130.0);
        EXPECT_EQ(reader.groundTruth().size(), 5u);
        EXPECT_TRUE(reader.gaps().empty());
        const auto frames = readAll(reader);
        ASSERT_EQ(frames.size(), 5u);
        EXPECT_EQ(frames[0].t_s, 1305031229.528748);
        EXPECT_EQ(frames[3].index, 3);
        for (int i = 0; i < 5; ++i)
            EXPECT_TRUE(sameImage(frames[static_cast<std::size_t>(i)].image, exampleImage(i)));
    }
}

TEST(RawlogReader, PicksTheFramesThatItIsAskedFor)
{
    TemporaryFolder folder;
    const std::string file = folder / "a.rawlog";
    writeExampleRawlog(file, exampleTimes(12));
    RawlogOptions options = optionsFor(file);
    options.first_frame = 2;
    options.every_nth = 3;
    options.frame_count = 3;
    RawlogReader reader(options, {});
    const auto frames = readAll(reader);
    ASSERT_EQ(frames.size(), 3u);
    EXPECT_EQ(frames[0].index, 2);
    EXPECT_EQ(frames[2].index, 8);
    EXPECT_TRUE(sameImage(frames[2].image, exampleImage(8)));
}

TEST(RawlogReader, ReportsAHoleInTimeAndGoesOn)
{
    TemporaryFolder folder;
    auto times = exampleTimes(10);
    times.erase(times.begin() + 4, times.begin() + 6);
    writeExampleRawlog(folder / "a.rawlog", times);
    RawlogReader reader(optionsFor(folder / "a.rawlog"), {});
    ASSERT_EQ(reader.gaps().size(), 1u);
    EXPECT_EQ(readAll(reader).size(), 8u);
}

TEST(RawlogReader, PrefersTheCalibrationOfTheIniIfAsked)
{
    TemporaryFolder folder;
    writeExampleRawlog(folder / "a.rawlog", exampleTimes(2));
    CameraOptions camera;
    camera.calibration = exampleRawlogCamera();
    camera.calibration->fx_px = 99.0;
    camera.readout_s = 0.02;
    const RawlogReader reader(optionsFor(folder / "a.rawlog"), camera);
    EXPECT_EQ(reader.camera().fx_px, 99.0);
    EXPECT_EQ(reader.camera().readout_s, 0.02);
}

TEST(RawlogReader, ReadsPlainFilesOfTheOlderFormat)
{
    TemporaryFolder folder;
    mrpt::obs::CActionCollection action;
    mrpt::obs::CSensoryFrame frames[2];
    for (int i = 0; i < 2; ++i)
    {
        auto image = mrpt::obs::CObservationImage::Create();
        image->timestamp = clockOf(kExampleStart + i * kExampleStep);
        image->cameraParams = toTCamera(exampleRawlogCamera());
        image->image = imageWith(i);
        frames[i].insert(image);
    }
    writePlain(folder / "old.rawlog", action, frames[0], action, frames[1]);
    RawlogReader reader(optionsFor(folder / "old.rawlog"), {});
    const auto images = readAll(reader);
    ASSERT_EQ(images.size(), 2u);
    EXPECT_TRUE(sameImage(images[1].image, exampleImage(1)));
}

TEST(RawlogReader, TakesTheSideOfAStereoPairThatItIsAskedFor)
{
    TemporaryFolder folder;
    mrpt::obs::CObservationStereoImages pair;
    pair.timestamp = clockOf(kExampleStart);
    pair.imageLeft = imageWith(1);
    pair.imageRight = imageWith(9);
    pair.hasImageRight = true;
    pair.leftCamera = pair.rightCamera = toTCamera(exampleRawlogCamera());
    pair.rightCamera.setIntrinsicParamsFromValues(140, 140, 79.5, 59.5);
    pair.rightCameraPose = mrpt::poses::CPose3DQuat(mrpt::poses::CPose3D(0.12, 0, 0));
    writePlain(folder / "stereo.rawlog", pair);
    RawlogOptions options = optionsFor(folder / "stereo.rawlog");
    RawlogReader left(options, {});
    EXPECT_TRUE(sameImage(left.next()->image, exampleImage(1)));
    options.stereo_side = StereoSide::Right;
    RawlogReader right(options, {});
    EXPECT_TRUE(sameImage(right.next()->image, exampleImage(9)));
    EXPECT_EQ(right.camera().fx_px, 140.0);
    EXPECT_NEAR(right.cameraPose().x(), 0.12, 1e-12);
}

TEST(RawlogReader, TakesTheIntensityOfARangeCamera)
{
    TemporaryFolder folder;
    mrpt::obs::CObservation3DRangeScan scan;
    scan.timestamp = clockOf(kExampleStart);
    scan.hasIntensityImage = true;
    scan.intensityImage = imageWith(3);
    scan.cameraParamsIntensity = toTCamera(exampleRawlogCamera());
    writePlain(folder / "rgbd.rawlog", scan);
    RawlogReader reader(optionsFor(folder / "rgbd.rawlog"), {});
    EXPECT_TRUE(sameImage(reader.next()->image, exampleImage(3)));
}
}  // namespace
}  // namespace monoslam
