// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <opencv2/calib3d.hpp>

#include "monoslam_models/Camera.h"
#include "randomValues.h"

namespace monoslam
{
namespace
{
CameraParameters parametersOf(DistortionModel model, std::array<double, 8> k)
{
    CameraParameters p;
    p.fx_px = 410.0;
    p.fy_px = 405.0;
    p.distortion = {model, k};
    return p;
}

cv::Matx33d matrixOf(const CameraParameters& p)
{
    return {p.fx_px, 0, p.cx_px, 0, p.fy_px, p.cy_px, 0, 0, 1};
}

std::vector<cv::Point3d> pointsInView(double extent)
{
    std::mt19937 rng(7);
    std::vector<cv::Point3d> points;
    for (int i = 0; i < 200; ++i)
    {
        const double z = uniform(rng, 0.5, 5.0);
        points.emplace_back(z * uniform(rng, -extent, extent), z * uniform(rng, -extent, extent),
                            z);
    }
    return points;
}

double worstDifference(const Camera& camera, const std::vector<cv::Point3d>& points,
                       const std::vector<cv::Point2d>& expected)
{
    double worst = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const Eigen::Vector3d h_c(points[i].x, points[i].y, points[i].z);
        const Eigen::Vector2d uv = camera.project(h_c).value();
        worst = std::max(worst, std::hypot(uv.x() - expected[i].x, uv.y() - expected[i].y));
    }
    return worst;
}
}  // namespace

TEST(DistortionAgainstOpenCv, BrownProjectsAsOpenCvDoesWithFiveAndWithEightNumbers)
{
    const std::vector<cv::Point3d> points = pointsInView(0.6);
    const std::array<double, 8> five{-0.28, 0.07, 1e-3, -5e-4, -0.008};
    const std::array<double, 8> eight{0.6, 0.15, 2e-4, -1e-4, 0.01, 0.9, 0.35, 0.04};
    for (const std::array<double, 8>& k : {five, eight})
    {
        const Camera camera(parametersOf(DistortionModel::Brown, k));
        std::vector<cv::Point2d> expected;
        cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), matrixOf(camera.parameters()),
                          std::vector<double>(k.begin(), k.end()), expected);
        EXPECT_LT(worstDifference(camera, points, expected), 1e-10);
    }
}

TEST(DistortionAgainstOpenCv, KannalaBrandtProjectsAsFisheyeDoes)
{
    const std::vector<cv::Point3d> points = pointsInView(1.5);
    const std::array<double, 8> k{-0.02, 0.006, -0.004, 0.0008};
    const Camera camera(parametersOf(DistortionModel::KannalaBrandt, k));
    std::vector<cv::Point2d> expected;
    cv::fisheye::projectPoints(points, expected, cv::Vec3d(), cv::Vec3d(),
                               matrixOf(camera.parameters()), cv::Vec4d(k[0], k[1], k[2], k[3]));
    EXPECT_LT(worstDifference(camera, points, expected), 1e-10);
}
}  // namespace monoslam
