// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "monoslam_slam/MetricStart.h"
#include "poseError.h"
#include "randomValues.h"
#include "renderPlane.h"

namespace monoslam
{
namespace
{
bool inBox(double x, double y, double halfX, double halfY)
{
    return std::abs(x) < halfX && std::abs(y) < halfY;
}

/** A dark rectangle on white paper on a grey desk with lighter and darker things around. */
double deskWithRectangle(double x, double y)
{
    if (inBox(x, y, 0.105, 0.07425)) return 0.012;
    if (inBox(x, y, 0.1485, 0.105)) return 0.8;
    if (inBox(x - 0.3, y, 0.05, 0.05)) return 0.02;
    if (inBox(x + 0.3, y - 0.1, 0.04, 0.1)) return 0.03;
    return 0.3;
}

/** The same beside a larger dark frame of the same shape round something light. */
double deskWithFrame(double x, double y)
{
    const double left = x + 0.45;
    if (inBox(left, y - 0.15, 0.21, 0.1485))
        return inBox(left, y - 0.15, 0.17, 0.1085) ? 0.6 : 0.02;
    return deskWithRectangle(x, y);
}

/** The same beside a larger tile of the same shape, dark on a floor that is not bright. */
double deskWithTile(double x, double y)
{
    if (inBox(x + 0.45, y - 0.15, 0.21, 0.1485)) return 0.05;
    return deskWithRectangle(x, y);
}

double deskWithTwins(double x, double y)
{
    return deskWithRectangle(x < -0.17 ? x + 0.34 : x, y);
}

double emptyDesk(double x, double y)
{
    return inBox(x - 0.1, y, 0.06, 0.06) ? 0.7 : 0.3;
}

/** Four small checker marks, no edges from one to the next; the last one may be missing. */
double marks(double x, double y)
{
    for (const double cx : {-0.12, 0.12})
        for (const double cy : {-0.08, 0.08})
            if (inBox(x - cx, y - cy, 0.03, 0.03)) return (x - cx) * (y - cy) > 0 ? 0.03 : 0.7;
    return 0.25;
}

double threeMarks(double x, double y)
{
    return x > 0 && y > 0 ? 0.25 : marks(x, y);
}

/** 7 x 5 inner corners of 0.04 m, corner (0, 0) at the origin, one square beyond on each side. */
double board(double x, double y)
{
    if (!inBox(x - 0.12, y - 0.08, 0.16, 0.12)) return 0.8;
    const int i = static_cast<int>(std::floor(x / 0.04)) + static_cast<int>(std::floor(y / 0.04));
    return i % 2 == 0 ? 0.02 : 0.8;
}

MetricStartOptions optionsFor(MetricStartMethod method)
{
    MetricStartOptions o;
    o.method = method;
    o.point_sigma_m = 0.0;
    o.chessboard_inner_corners = {7, 5};
    return o;
}

std::vector<Eigen::Vector2d> roughPixels(const Camera& camera, const Vector7d& pose,
                                         const std::vector<Eigen::Vector3d>& points, double off_px)
{
    std::mt19937 rng(8);
    auto pixels = seenBy(camera, pose, points);
    for (auto& uv_px : pixels) uv_px += off_px * normalVector<2>(rng, 1.0).normalized();
    return pixels;
}

/** Largest distance of the refined corners from the true ones. */
double cornerError(const MetricPose& found, const Camera& camera, const Vector7d& truth)
{
    const auto exact = seenBy(camera, truth, found.points_m);
    double worst_px = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i)
        worst_px = std::max(worst_px, (found.pixels_px[i] - exact[i]).norm());
    return worst_px;
}

/** That a rectangle at the origin is found though something larger lies to its left. */
void expectRectangleBeside(double (*desk)(double, double))
{
    const Camera camera = wideCamera();
    const Vector7d truth = lookAt({-0.15, -0.4, 0.65}, {-0.2, 0.05, 0.0}, 0.0);
    const cv::Mat image = renderPlane({desk}, camera, truth, {0.6, 2.0, true, 3});
    const auto result = findMetricPose(image, camera, optionsFor(MetricStartMethod::Rectangle));
    ASSERT_TRUE(result.found) << result.reason;
    EXPECT_LT((result.found->pose - truth).head<3>().norm(), 0.005);
}
}  // namespace

TEST(FindTarget, RectangleIsMeasuredToATwentiethPixelWhateverTheSensorsResponse)
{
    const Camera camera = wideCamera();
    const auto o = optionsFor(MetricStartMethod::Rectangle);
    unsigned seed = 0;
    for (const bool srgb : {true, false})
        for (const Eigen::Vector3d& from :
             {Eigen::Vector3d(0.02, -0.35, 0.35), {0.2, -0.2, 0.4}, {-0.15, -0.2, 0.3}})
        {
            const Vector7d truth = lookAt(from, {0.01, 0.0, 0.0}, 0.2);
            const cv::Mat image =
                renderPlane({deskWithRectangle}, camera, truth, {0.6, 2.0, srgb, ++seed});
            const auto result = findMetricPose(image, camera, o);
            ASSERT_TRUE(result.found) << result.reason;
            EXPECT_LT(cornerError(*result.found, camera, truth), 0.06) << srgb << from;
            EXPECT_LT(mahalanobis2(truth, result.found->pose, result.found->P), 16.8);
            EXPECT_LT((result.found->pose - truth).head<3>().norm(), 0.002);
        }
}

TEST(FindTarget, AFrameRoundSomethingElseIsNoRectangle)
{
    expectRectangleBeside(deskWithFrame);
}

TEST(FindTarget, TheStrongestEdgesAreTheTargetsNotTheLargestTiles)
{
    expectRectangleBeside(deskWithTile);
}

TEST(FindTarget, ARivalIsNamed)
{
    const Camera camera = wideCamera();
    const Vector7d truth = lookAt({-0.15, -0.4, 0.5}, {-0.15, 0.05, 0.0}, 0.0);
    const cv::Mat image = renderPlane({deskWithTwins}, camera, truth, {0.6, 2.0, true, 3});
    const auto result = findMetricPose(image, camera, optionsFor(MetricStartMethod::Rectangle));
    ASSERT_TRUE(result.found);
    EXPECT_EQ(result.reason, "2 rectangles fit; the one of strongest edges was taken");
}

TEST(FindTarget, ASmallBlurredRectangleIsFilledToo)
{
    const Camera camera = wideCamera();
    const Vector7d truth = lookAt({0.3, -0.9, 0.45}, {0.0, 0.0, 0.0}, 0.0);
    const cv::Mat image = renderPlane({deskWithRectangle}, camera, truth, {1.2, 2.0, true, 4});
    const auto result = findMetricPose(image, camera, optionsFor(MetricStartMethod::Rectangle));
    ASSERT_TRUE(result.found) << result.reason;
    EXPECT_LT(cornerError(*result.found, camera, truth), 1.0);
}

TEST(FindTarget, AnAbsentRectangleIsSaidToBeAbsent)
{
    const Camera camera = wideCamera();
    const Vector7d pose = lookAt({0.02, -0.35, 0.35}, {0, 0, 0});
    for (const auto method : {MetricStartMethod::Rectangle, MetricStartMethod::Chessboard})
    {
        const cv::Mat image = renderPlane({emptyDesk}, camera, pose, {});
        const auto result = findMetricPose(image, camera, optionsFor(method));
        EXPECT_FALSE(result.found);
        EXPECT_FALSE(result.reason.empty());
    }
}

TEST(FindTarget, GivenPointsAreRefinedFromPixelsThatAreFarOff)
{
    const Camera camera = wideCamera();
    auto o = optionsFor(MetricStartMethod::TargetPoints);
    o.target_points_m = {{0.12, 0.08, 0}, {-0.12, -0.08, 0}, {0.12, -0.08, 0}, {-0.12, 0.08, 0}};
    const Vector7d truth = lookAt({0.1, -0.3, 0.35}, {0.02, 0.01, 0}, -0.2);
    o.target_points_px = roughPixels(camera, truth, o.target_points_m, 4.5);
    const cv::Mat image = renderPlane({marks}, camera, truth, {});
    const auto result = findMetricPose(image, camera, o);
    ASSERT_TRUE(result.found) << result.reason;
    EXPECT_EQ(result.reason, "");
    EXPECT_LT(cornerError(*result.found, camera, truth), 0.1);
    EXPECT_LT(mahalanobis2(truth, result.found->pose, result.found->P), 16.8);
}

TEST(FindTarget, WhereThereIsNoCornerTheRoughPixelStaysWithALargerSigma)
{
    const Camera camera = wideCamera();
    auto o = optionsFor(MetricStartMethod::TargetPoints);
    o.target_points_m = {{0.12, 0.08, 0}, {-0.12, -0.08, 0}, {0.12, -0.08, 0}, {-0.12, 0.08, 0}};
    const Vector7d truth = lookAt({0.1, -0.3, 0.35}, {0.02, 0.01, 0}, -0.2);
    o.target_points_px = roughPixels(camera, truth, o.target_points_m, 1.5);
    const cv::Mat image = renderPlane({threeMarks}, camera, truth, {});
    const auto result = findMetricPose(image, camera, o);
    ASSERT_TRUE(result.found) << result.reason;
    EXPECT_NE(result.reason.find("target point 1"), std::string::npos) << result.reason;
    EXPECT_EQ(result.found->pixels_px[0], o.target_points_px[0]);
    EXPECT_GT(result.found->sigmas_px[0], 1.0);
    EXPECT_LT(mahalanobis2(truth, result.found->pose, result.found->P), 16.8);
}

TEST(FindTarget, CornersEightPixelsFromTheBorderAreRefinedOnAnyPlane)
{
    const Camera camera = wideCamera();
    std::mt19937 rng(2);
    for (const auto& light : {deskWithRectangle, marks})
    {
        const bool filled = light == deskWithRectangle;
        const double hx = filled ? 0.105 : 0.12;
        const double hy = filled ? 0.07425 : 0.08;
        // turn the camera until the nearest corner lies 8 px from the left and the lower border
        const Eigen::Vector3d corner(-hx, -hy, 0);
        Vector7d local = lookAt({0.02, -0.3, 0.33}, {0, 0, 0});
        for (int i = 0; i < 20; ++i)
        {
            const Eigen::Vector3d want = camera.unproject({8.0, 291.0})->normalized();
            const Eigen::Vector3d is =
                rotateInverse(local.tail<4>(), corner - local.head<3>()).normalized();
            local.tail<4>() = quaternionProduct(local.tail<4>(), quaternionExp(-is.cross(want)));
        }
        const Eigen::Vector4d q_wp = randomQuaternion(rng);
        const Eigen::Vector3d r_wp(1.0, -2.0, 0.5);
        Vector7d truth;
        truth << rotate(q_wp, local.head<3>()) + r_wp, quaternionProduct(q_wp, local.tail<4>());
        auto o = optionsFor(MetricStartMethod::TargetPoints);
        for (const Eigen::Vector3d& p :
             {Eigen::Vector3d(hx, hy, 0), {-hx, hy, 0}, {hx, -hy, 0}, {-hx, -hy, 0}})
            o.target_points_m.emplace_back(rotate(q_wp, p) + r_wp);
        o.target_points_px = roughPixels(camera, truth, o.target_points_m, 3.0);
        const cv::Mat image = renderPlane({light, rotationMatrix(q_wp), r_wp}, camera, truth, {});
        const auto result = findMetricPose(image, camera, o);
        ASSERT_TRUE(result.found) << result.reason;
        EXPECT_EQ(result.reason, "");
        EXPECT_LT(cornerError(*result.found, camera, truth), 0.15);
        EXPECT_LT(mahalanobis2(truth, result.found->pose, result.found->P), 16.8);
    }
}

TEST(FindTarget, ChessboardsOriginIsItsFirstInnerCorner)
{
    const Camera camera = wideCamera();
    const auto o = optionsFor(MetricStartMethod::Chessboard);
    for (const Eigen::Vector3d& from : {Eigen::Vector3d(0.15, 0.3, -0.3), {0.3, 0.15, -0.3}})
    {
        const Vector7d truth = lookAt(from, {0.12, 0.08, 0}, 3.2);
        const cv::Mat image = renderPlane({board}, camera, truth, {});
        const auto result = findMetricPose(image, camera, o);
        ASSERT_TRUE(result.found) << result.reason;
        EXPECT_LT(cornerError(*result.found, camera, truth), 0.15);
        EXPECT_LT(mahalanobis2(truth, result.found->pose, result.found->P), 16.8);
    }
}
}  // namespace monoslam
