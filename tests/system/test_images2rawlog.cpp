// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "TemporaryFolder.h"
#include "exampleRawlog.h"
#include "monoslam_mrpt/RawlogReader.h"
#include "runProgram.h"

namespace monoslam
{
namespace
{
constexpr const char* kCameraYaml =
    "width: 160\nheight: 120\nfx: 130\nfy: 130\ncx: 79.5\ncy: 59.5\nk1: 0.01\nlens: cheap\n";

/** A folder with a calibration, to which a test adds a sequence of its format. */
class Images2Rawlog : public testing::Test
{
   protected:
    Images2Rawlog() { writeText(folder_ / "camera.yaml", kCameraYaml); }

    void saveImage(const std::string& name, int index) const
    {
        const std::filesystem::path file(folder_ / name);
        std::filesystem::create_directories(file.parent_path());
        cv::imwrite(file.string(), exampleImage(index));
    }

    [[nodiscard]] ProgramResult convert(const std::string& format, const std::string& input,
                                        const std::string& more = {}) const
    {
        return runProgram("images2rawlog", "--format " + format + " --input '" + folder_ / input +
                                               "' --camera '" + folder_ / "camera.yaml" +
                                               "' --output '" + folder_ / "out.rawlog" + "' " +
                                               more);
    }

    [[nodiscard]] std::vector<Frame> frames() const
    {
        RawlogOptions options;
        options.file = folder_ / "out.rawlog";
        RawlogReader reader(options, {});
        std::vector<Frame> all;
        while (auto frame = reader.next()) all.push_back(std::move(*frame));
        return all;
    }

    void writeTum() const
    {
        writeText(folder_ / "tum/rgb.txt",
                  "# t file\n0.5 rgb/a.png\n1305031229.528748 rgb/b.png\n");
        saveImage("tum/rgb/a.png", 0);
        saveImage("tum/rgb/b.png", 1);
    }

    TemporaryFolder folder_;
};

TEST_F(Images2Rawlog, ConvertsTumAndWarnsOnceOfFurtherKeys)
{
    writeTum();
    writeText(folder_ / "truth.txt", "0.5 1 2 3 0 0 0 1\n0.6 1 2 4 0 0 0 1\n");
    const auto result = convert("tum", "tum", "--groundtruth '" + folder_ / "truth.txt" + "'");
    ASSERT_EQ(result.status, 0) << result.output;
    EXPECT_NE(result.output.find("ignored: lens"), std::string::npos) << result.output;
    ASSERT_EQ(frames().size(), 2u);
    EXPECT_EQ(frames()[1].t_s, 1305031229.528748);
    EXPECT_EQ(cv::countNonZero(frames()[1].image != exampleImage(1)), 0);
    const auto truth = scanRawlog(folder_ / "out.rawlog").groundTruth;
    ASSERT_EQ(truth.size(), 2u);
    EXPECT_EQ(truth[1].pose.z(), 4.0);
}

TEST_F(Images2Rawlog, EmbedsImagesIfAsked)
{
    writeTum();
    ASSERT_EQ(convert("tum", "tum", "--embed").status, 0);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out_Images"));
    EXPECT_EQ(cv::countNonZero(frames()[1].image != exampleImage(1)), 0);
}

TEST_F(Images2Rawlog, ConvertsEurocWithTheTruthOfTheBody)
{
    writeText(folder_ / "mav0/cam0/data.csv",
              "#timestamp [ns],filename\n1403636579763555584,a.png\n1403636579813555456,b.png\n");
    saveImage("mav0/cam0/data/a.png", 0);
    saveImage("mav0/cam0/data/b.png", 1);
    writeText(folder_ / "truth.csv", "#ns,x,y,z,w,...\n1403636579763555584,1,2,3,1,0,0,0,9,9\n");
    ASSERT_EQ(convert("euroc", "", "--groundtruth '" + folder_ / "truth.csv" + "'").status, 0);
    EXPECT_EQ(scanRawlog(folder_ / "out.rawlog").imageTimes["camera"][0], 14036365797635556);
    EXPECT_EQ(scanRawlog(folder_ / "out.rawlog").groundTruth.at(0).pose.y(), 2.0);
}

TEST_F(Images2Rawlog, ConvertsKitti)
{
    writeText(folder_ / "kitti/times.txt", "0.000000e+00\n1.037875e-01\n");
    saveImage("kitti/image_0/000000.png", 0);
    saveImage("kitti/image_0/000001.png", 1);
    writeText(folder_ / "poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 5 0 1 0 0 0 0 1 0\n");
    ASSERT_EQ(convert("kitti", "kitti", "--groundtruth '" + folder_ / "poses.txt" + "'").status, 0);
    EXPECT_EQ(frames().at(1).t_s, 0.1037875);
    EXPECT_EQ(scanRawlog(folder_ / "out.rawlog").groundTruth.at(1).pose.x(), 5.0);
}

TEST_F(Images2Rawlog, ConvertsAFolderOnlyWithAFrameRate)
{
    saveImage("pictures/1.jpg", 0);
    saveImage("pictures/2.bmp", 1);
    EXPECT_EQ(convert("folder", "pictures").status, 1);
    ASSERT_EQ(convert("folder", "pictures", "--fps 20").status, 0);
    EXPECT_EQ(frames().at(1).t_s, 0.05);
}

TEST_F(Images2Rawlog, ConvertsAVideo)
{
    cv::VideoWriter video(folder_ / "a.avi", cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10.0,
                          {160, 120}, false);
    if (!video.isOpened()) GTEST_SKIP() << "this OpenCV writes no video";
    for (int i = 0; i < 3; ++i) video.write(exampleImage(i));
    video.release();
    ASSERT_EQ(convert("video", "a.avi").status, 0);
    ASSERT_EQ(frames().size(), 3u);
    EXPECT_NEAR(frames()[2].t_s - frames()[1].t_s, 0.1, 1e-6);
}

TEST_F(Images2Rawlog, ReplacesOnlyWithForce)
{
    writeTum();
    ASSERT_EQ(convert("tum", "tum").status, 0);
    EXPECT_EQ(convert("tum", "tum").status, 1);
    EXPECT_EQ(convert("tum", "tum", "--force").status, 0);
}

TEST_F(Images2Rawlog, NamesTheLineThatIsWrong)
{
    writeTum();
    writeText(folder_ / "tum/rgb.txt", "0.5 rgb/a.png\nlater rgb/b.png\n");
    const auto result = convert("tum", "tum");
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.output.find("rgb.txt:2"), std::string::npos) << result.output;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out.rawlog"));
}

TEST_F(Images2Rawlog, NamesTheImageThatCannotBeDecoded)
{
    writeTum();
    writeText(folder_ / "tum/rgb/b.png", "no image");
    const auto result = convert("tum", "tum");
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.output.find("b.png"), std::string::npos) << result.output;
}
}  // namespace
}  // namespace monoslam
