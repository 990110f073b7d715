// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/serialization/CArchive.h>

#include <opencv2/imgcodecs.hpp>

#include "SpoiledRun.h"

namespace monoslam
{
namespace
{
namespace fs = std::filesystem;
using BadRawlog = SpoiledRun;

TEST_F(BadRawlog, MissingRawlog)
{
    expectOneLine(run("--set rawlog.file=absent.rawlog"), {"absent.rawlog", "no such"});
}

TEST_F(BadRawlog, FileThatIsNoRawlog)
{
    writeText(rawlog_, "this is not a rawlog at all, only text");
    expectOneLine(run(), {"good.rawlog", "not a rawlog"});
}

TEST_F(BadRawlog, TruncatedRawlog)
{
    fs::resize_file(rawlog_, fs::file_size(rawlog_) / 2);
    expectOneLine(run("--dry-run"), {"good.rawlog", "truncated", "objects"});
    EXPECT_FALSE(fs::exists(out_));
    expectOneLine(run(), {"good.rawlog", "truncated", "objects"});
    EXPECT_GT(linesOf("trajectory.tum"), 5);  // the frames before the damage
    EXPECT_LT(linesOf("trajectory.tum"), 30);
    expectResultsSoFar();
    EXPECT_NE(readText(out_ + "/summary.json").find("truncated"), std::string::npos);
}

TEST_F(BadRawlog, TruncatedAfterTheLastFrameThatWasAskedFor)
{
    fs::resize_file(rawlog_, fs::file_size(rawlog_) / 2);
    const auto result = run("--set rawlog.frame_count=5");
    EXPECT_EQ(result.status, 0) << result.output;
}

TEST_F(BadRawlog, RawlogWithoutImages)
{
    fs::remove(rawlog_);
    fs::remove_all(folder_ / "good_Images");
    RawlogWriterOptions options;
    options.file = rawlog_;
    options.embed = true;
    RawlogWriter writer(options);
    writer.addTruth(kExampleStart, {});
    writer.close();
    expectOneLine(run(), {"good.rawlog", "no images"});
    EXPECT_FALSE(fs::exists(out_));
}

TEST_F(BadRawlog, ImageThatIsMissing)
{
    fs::remove(image(5));
    expectOneLine(run(), {"good.rawlog", "frame 5", "000005.png", "missing"});
}

TEST_F(BadRawlog, ImageThatCannotBeDecoded)
{
    fs::resize_file(image(5), 700);
    expectOneLine(run(), {"frame 5", "000005.png", "decoded"});
    EXPECT_EQ(linesOf("trajectory.tum"), 5);
    expectResultsSoFar();
}

TEST_F(BadRawlog, ImageOfAnotherSize)
{
    cv::imwrite(image(5), cv::Mat(100, 100, CV_8UC1, cv::Scalar(9)));
    expectOneLine(run(), {"frame 5", "100x100", "160x120"});
}

TEST_F(BadRawlog, TimeThatGoesBackwards)
{
    auto times = exampleTimes(10);
    std::swap(times[4], times[5]);
    rewriteWith(times);
    expectOneLine(run(), {"good.rawlog", "frame 5", "backwards"});
}

TEST_F(BadRawlog, DuplicateFrame)
{
    auto times = exampleTimes(10);
    times[5] = times[4];
    rewriteWith(times);
    expectOneLine(run(), {"good.rawlog", "frame 5", "duplicate"});
}

TEST_F(BadRawlog, MissingFramesAreReportedAndNoError)
{
    auto times = exampleTimes(30);
    times.erase(times.begin() + 8, times.begin() + 10);
    rewriteWith(times);
    const auto result = run();
    EXPECT_EQ(result.status, 0) << result.output;
    EXPECT_NE(result.output.find("without a frame"), std::string::npos) << result.output;
    EXPECT_NE(readText(out_ + "/summary.json").find("without a frame"), std::string::npos);
}

TEST_F(BadRawlog, FrameWithoutCalibration)
{
    for (const int without : {0, 1})
    {
        mrpt::io::CFileGZOutputStream stream(rawlog_);
        for (int i = 0; i <= without; ++i)
        {
            mrpt::obs::CObservationImage observation;
            observation.timestamp = clockOf(kExampleStart + i * kExampleStep);
            observation.image.setExternalStorage("000000.png");
            if (i < without) observation.cameraParams = toTCamera(exampleRawlogCamera());
            mrpt::serialization::archiveFrom(stream) << observation;
        }
        stream.close();
        expectOneLine(run("--force"), {"good.rawlog", "frame " + std::to_string(without),
                                       "calibration", "[camera]"});
    }
}

TEST_F(BadRawlog, SeveralLabels)
{
    mrpt::io::CFileGZOutputStream stream(rawlog_);
    mrpt::obs::CObservationImage observation;
    observation.timestamp = clockOf(kExampleStart);
    observation.image.setExternalStorage("000000.png");
    for (const char* label : {"front", "rear"})
    {
        observation.sensorLabel = label;
        mrpt::serialization::archiveFrom(stream) << observation;
    }
    stream.close();
    expectOneLine(run(), {"sensor_label", "'front'", "'rear'"});
    expectOneLine(run("--set rawlog.sensor_label=left"), {"'left'", "'front'", "'rear'"});
}
}  // namespace
}  // namespace monoslam
