// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "TemporaryFolder.h"
#include "exampleRawlog.h"

namespace monoslam
{
namespace
{
TEST(CameraFrom, SurvivesTheWayThroughARawlog)
{
    CameraParameters p = exampleRawlogCamera();
    p.distortion = {DistortionModel::Brown, {-0.3, 0.1, 1e-3, 2e-3, 0.02, 0.01, 0.005, 1e-3}};
    EXPECT_EQ(cameraFrom(toTCamera(p)).distortion.k, p.distortion.k);
    p.distortion = {DistortionModel::KannalaBrandt, {0.01, 0.02, 0.03, 0.04}};
    EXPECT_EQ(cameraFrom(toTCamera(p)).distortion.k, p.distortion.k);
    EXPECT_EQ(cameraFrom(toTCamera(p)).distortion.model, DistortionModel::KannalaBrandt);
    p.distortion = {DistortionModel::Tsai, {0.06, 0.013, 0.0112}};
    EXPECT_THROW(static_cast<void>(toTCamera(p)), std::invalid_argument);
}

TEST(CameraFrom, ReadsEurocAndListsWhatItIgnores)
{
    TemporaryFolder folder;
    writeText(folder / "sensor.yaml",
              "sensor_type: camera\nrate_hz: 20\nresolution: [752, 480]\n"
              "camera_model: pinhole\nintrinsics: [458.654, 457.296, 367.215, 248.375]\n"
              "distortion_model: radial-tangential\n"
              "distortion_coefficients: [-0.283, 0.0739, 0.00019, 1.76e-05]\n"
              "T_BS:\n  cols: 4\n  rows: 4\n"
              "  data: [1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\n");
    const CameraFile file = readCameraFile(folder / "sensor.yaml");
    EXPECT_EQ(file.camera.width_px, 752);
    EXPECT_EQ(file.camera.cy_px, 248.375);
    EXPECT_EQ(file.camera.distortion.k[3], 1.76e-05);
    EXPECT_NEAR(file.cameraPose.x(), 0.5, 1e-12);
    EXPECT_EQ(file.ignoredKeys.size(), 3u);
}

TEST(CameraFrom, ReadsAnIniOfMrptAndOneOfOurs)
{
    TemporaryFolder folder;
    writeText(folder / "mrpt.ini",
              "[CAMERA_PARAMS]\nresolution = [640 480]\nfx = 500\nfy = 501\ncx = 320\ncy = 240\n"
              "distortion_model = kannala_brandt\ndist = [0.01 0.02 0.03 0.04]\n");
    writeText(folder / "ours.ini",
              "[camera]\nsource = ini\nwidth_px = 640\nheight_px = 480\nfx_px = 500\n"
              "fy_px = 501\ncx_px = 320\ncy_px = 240\ndistortion_model = davison\n"
              "distortion = 6e-6\n");
    const CameraFile mrptFile = readCameraFile(folder / "mrpt.ini");
    EXPECT_EQ(mrptFile.camera.fy_px, 501.0);
    EXPECT_EQ(mrptFile.camera.distortion.k[3], 0.04);
    EXPECT_EQ(readCameraFile(folder / "ours.ini").camera.distortion.k[0], 6e-6);
}

TEST(Timestamps, NeverPassThroughADouble)
{
    EXPECT_EQ(parseSeconds("1305031229.528748"), kExampleStart);
    EXPECT_EQ(parseSeconds("0.00000014"), 1);
    EXPECT_EQ(parseSeconds("1.5e-1"), 1500000);
    EXPECT_EQ(parseNanoseconds("1403636579763555584"), 14036365797635556);
    EXPECT_FALSE(parseSeconds("12.x"));
    EXPECT_FALSE(parseNanoseconds(""));
    EXPECT_EQ(ticksOf(clockOf(kExampleStart)), kExampleStart);
}
}  // namespace
}  // namespace monoslam
