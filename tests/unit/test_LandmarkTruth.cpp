// SPDX-License-Identifier: BSD-3-Clause
#include "LandmarkTruth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "TemporaryFolder.h"

namespace monoslam
{
namespace
{
constexpr double kWall_m = 2.0;
constexpr double kPost_m = 1.0;   // stands before the wall, from x = 0 on
constexpr double kStep_m = 0.03;  // the camera goes to the right
constexpr double kPictureUnit = 5000.0;

CameraParameters smallCamera()
{
    CameraParameters camera;
    camera.fx_px = camera.fy_px = 100.0;
    camera.cx_px = 79.5;
    camera.cy_px = 59.5;
    camera.width_px = 160;
    camera.height_px = 120;
    return camera;
}

Trajectory path()
{
    Trajectory truth(12);
    for (std::size_t i = 0; i < truth.size(); ++i)
    {
        truth[i].t_s = 0.1 * static_cast<double>(i);
        truth[i].r_wc.x() = kStep_m * static_cast<double>(i);
    }
    return truth;
}

/** Depth of frame `index`, of the wall and of the post's front. */
void writeDepth(const std::string& folder, int index)
{
    const CameraParameters camera = smallCamera();
    cv::Mat depth(camera.height_px, camera.width_px, CV_16UC1);
    for (int v = 0; v < depth.rows; ++v)
        for (int u = 0; u < depth.cols; ++u)
        {
            const double x = (u - camera.cx_px) / camera.fx_px * kPost_m + kStep_m * index;
            const double z = x >= 0.0 ? kPost_m : kWall_m;
            depth.at<std::uint16_t>(v, u) = static_cast<std::uint16_t>(z * kPictureUnit);
        }
    char name[32];
    std::snprintf(name, sizeof name, "/%04d.png", index);
    cv::imwrite(folder + name, depth);
}

class LandmarkTruthTest : public testing::Test
{
   protected:
    LandmarkTruthTest()
    {
        writeDepth(folder_.path(), 0);
        writeDepth(folder_.path(), 11);
    }

    [[nodiscard]] std::optional<TruePoint> at(int frame, double u, double v)
    {
        return truth_.point(0.1 * frame, {u, v});
    }

    TemporaryFolder folder_;
    LandmarkTruth truth_{path(), smallCamera(), folder_.path()};
};
}  // namespace

TEST_F(LandmarkTruthTest, FrameWithItsOwnPicture)
{
    const auto wall = at(0, 19.25, 39.5);
    ASSERT_TRUE(wall);
    EXPECT_TRUE(wall->p_w.isApprox(Eigen::Vector3d(-1.205, -0.4, 2.0), 1e-3));
    EXPECT_NEAR(wall->distance_m, wall->p_w.norm(), 1e-12);
    const auto post = at(0, 129.5, 59.5);
    ASSERT_TRUE(post);
    EXPECT_TRUE(post->p_w.isApprox(Eigen::Vector3d(0.5, 0.0, 1.0), 1e-3));
}

TEST_F(LandmarkTruthTest, CornerOnAnEdgeBelongsToTheFront)
{
    const auto edge = at(0, 79.6, 59.5);
    ASSERT_TRUE(edge);
    EXPECT_NEAR(edge->p_w.z(), kPost_m, 1e-3);
}

TEST_F(LandmarkTruthTest, FrameWithoutPictureUsesTheNearest)
{
    const auto wall = at(4, 19.25, 39.5);
    ASSERT_TRUE(wall);
    EXPECT_TRUE(wall->p_w.isApprox(Eigen::Vector3d(-1.205 + 4 * kStep_m, -0.4, 2.0), 1e-3));
    const auto post = at(4, 129.5, 59.5);
    ASSERT_TRUE(post);
    EXPECT_TRUE(post->p_w.isApprox(Eigen::Vector3d(0.5 + 4 * kStep_m, 0.0, 1.0), 1e-3));
    EXPECT_NEAR(post->distance_m, std::hypot(0.5, 1.0), 2e-3);
}

/** Frame 4 sees the wall up to x = -0.12, frame 5 only up to -0.15: between them the ray goes behind
 *  the post of picture 5. */
TEST_F(LandmarkTruthTest, SaysNothingOfWhatThePictureHides)
{
    writeDepth(folder_.path(), 5);
    LandmarkTruth truth(path(), smallCamera(), folder_.path());
    EXPECT_FALSE(truth.point(0.4, {66.75, 59.5}));
    const auto seen = truth.point(0.4, {64.5, 59.5});
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->p_w.z(), kWall_m, 1e-3);
}

TEST_F(LandmarkTruthTest, SaysNothingOutsideWithoutPoseOrWithoutDepth)
{
    EXPECT_FALSE(at(0, -1.0, 40.0));
    EXPECT_FALSE(at(0, 159.5, 40.0));
    EXPECT_FALSE(at(20, 40.0, 40.0));
    EXPECT_FALSE(truth_.point(0.05, {40.0, 40.0}));
    cv::imwrite(folder_ / "0003.png", cv::Mat::zeros(120, 160, CV_16UC1));
    EXPECT_FALSE(at(3, 40.0, 40.0));
}

TEST_F(LandmarkTruthTest, RejectsWrongFiles)
{
    EXPECT_THROW(LandmarkTruth(path(), smallCamera(), folder_ / "none"), std::invalid_argument);
    cv::imwrite(folder_ / "0002.png", cv::Mat::zeros(120, 160, CV_8UC1));
    EXPECT_THROW((void)at(2, 40.0, 40.0), std::invalid_argument);
}
}  // namespace monoslam
