// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "exampleCameras.h"
#include "jacobianMatches.h"
#include "monoslam_models/Camera.h"

namespace monoslam
{
namespace
{
std::string errorOf(const CameraParameters& parameters)
{
    try
    {
        (void)Camera(parameters);
    }
    catch (const std::invalid_argument& error)
    {
        return error.what();
    }
    return "(no error)";
}
}  // namespace

TEST(Camera, ProjectsWithoutDistortionByThePinholeFormula)
{
    const Camera camera(cameraParameters(DistortionModel::None, {}));
    const std::optional<Eigen::Vector2d> uv = camera.project({0.2, -0.1, 0.5});
    ASSERT_TRUE(uv);
    EXPECT_LT((*uv - Eigen::Vector2d(318.0 + 420 * 0.4, 242.0 - 415 * 0.2)).norm(), 1e-12);
}

TEST(Camera, GivesBackEveryPixelAfterUnprojection)
{
    forEachCamera(
        [](const Camera& camera)
        {
            for (const Eigen::Vector2d& uv : pixels(camera))
            {
                const std::optional<Eigen::Vector3d> ray = camera.unproject(uv);
                ASSERT_TRUE(ray) << uv.transpose();
                const std::optional<Eigen::Vector2d> back = camera.project(*ray);
                ASSERT_TRUE(back) << uv.transpose();
                EXPECT_LT((*back - uv).norm(), 1e-9) << uv.transpose();
            }
        });
}

TEST(Camera, GivesBackEveryRayAfterProjectionAtAnyScale)
{
    std::mt19937 rng(1);
    forEachCamera(
        [&](const Camera& camera)
        {
            for (int i = 0; i < 200; ++i)
            {
                const Eigen::Vector3d h_c = pointInView(rng, camera, 0.97);
                const std::optional<Eigen::Vector2d> uv = camera.project(h_c);
                ASSERT_TRUE(uv) << h_c.transpose();
                EXPECT_LT((*camera.project(7 * h_c) - *uv).norm(), 1e-9);
                const std::optional<Eigen::Vector3d> ray = camera.unproject(*uv);
                ASSERT_TRUE(ray) << h_c.transpose();
                EXPECT_LT((*ray - h_c / h_c.z()).norm(), 1e-9) << h_c.transpose();
            }
        });
}

TEST(Camera, ProjectionJacobianMatchesDifferences)
{
    std::mt19937 rng(2);
    forEachCamera(
        [&](const Camera& camera)
        {
            const auto f = [&](const Eigen::Vector3d& h_c) { return camera.project(h_c).value(); };
            std::vector<Eigen::Vector3d> points{{0, 0, 1}, {1e-6, 0, 1}, {9e-5, 5e-5, 1}};
            for (int i = 0; i < 120; ++i) points.push_back(pointInView(rng, camera, 0.9));
            for (const Eigen::Vector2d& uv : pixels(camera))
                points.push_back(2 * camera.unproject(uv).value());
            for (const Eigen::Vector3d& h_c : points)
            {
                Matrix23d J;
                ASSERT_TRUE(camera.project(h_c, &J));
                EXPECT_TRUE(jacobianMatches(f, h_c, J)) << h_c.transpose();
            }
        });
}

TEST(Camera, UnprojectionJacobianMatchesDifferences)
{
    std::mt19937 rng(3);
    forEachCamera(
        [&](const Camera& camera)
        {
            const double f_px = camera.parameters().fx_px;  // makes the tolerance relative
            const auto f = [&](const Eigen::Vector2d& uv)
            { return Eigen::Vector2d(f_px * camera.unproject(uv).value().head<2>()); };
            std::vector<Eigen::Vector2d> points = pixels(camera);
            points.emplace_back(camera.parameters().cx_px, camera.parameters().cy_px);
            for (const Eigen::Vector2d& uv : points)
            {
                Eigen::Matrix2d J;
                ASSERT_TRUE(camera.unproject(uv, &J));
                EXPECT_TRUE(jacobianMatches(f, uv, f_px * J, 1e-7, 1e-2)) << uv.transpose();
            }
        });
}

TEST(Camera, SeesNothingBehindOrBeyondItsValidAngle)
{
    forEachCamera(
        [](const Camera& camera)
        {
            EXPECT_FALSE(camera.project({0.1, 0.1, -1}));
            EXPECT_FALSE(camera.project({0, 0, 0}));
            EXPECT_FALSE(camera.project({0.1, 0, 0}));
            const double angle = camera.maxAngle_rad();
            for (int i = 0; i < 8; ++i)
            {
                const Eigen::Vector2d side(std::cos(i * 45 * kDegree), std::sin(i * 45 * kDegree));
                const Eigen::Vector2d inside = std::tan(angle - 1e-6) * side;
                const Eigen::Vector2d outside = std::tan(angle + 1e-6) * side;
                EXPECT_TRUE(camera.project(inside.homogeneous()));
                EXPECT_FALSE(camera.project(outside.homogeneous()));
            }
            EXPECT_FALSE(camera.project({std::nan(""), 0, 1}));
        });
}

TEST(Camera, RefusesPixelsBeyondTheFold)
{
    // r - 0.3 r^3 is largest, 0.7027, at r = 1.054
    const Camera camera(cameraParameters(DistortionModel::Brown, {-0.3}));
    EXPECT_TRUE(camera.unproject({318.0 + 0.702 * 420, 242.0}));
    EXPECT_FALSE(camera.unproject({318.0 + 0.704 * 420, 242.0}));
    EXPECT_FALSE(camera.unproject({318.0 + 2.0 * 420, 242.0}));
    // Davison has no ray for 2 K1 |p|^2 >= 1
    const Camera sceneLibCamera(sceneLibParameters());
    EXPECT_TRUE(sceneLibCamera.unproject({162.0 + 235.0, 125.0}));
    EXPECT_FALSE(sceneLibCamera.unproject({162.0 + 236.0, 125.0}));
}

TEST(Camera, ContainsThePixelsInsideItsBorder)
{
    const Camera camera;
    EXPECT_TRUE(camera.contains({0, 0}));
    EXPECT_TRUE(camera.contains({639, 479}));
    EXPECT_FALSE(camera.contains({639.01, 479}));
    EXPECT_FALSE(camera.contains({-0.01, 5}));
    EXPECT_TRUE(camera.contains({10, 469}, 10));
    EXPECT_FALSE(camera.contains({9.9, 100}, 10));
    EXPECT_FALSE(camera.contains({100, 469.1}, 10));
}

TEST(Camera, NamesTheParameterItRefuses)
{
    const double kNan = std::numeric_limits<double>::quiet_NaN();
    const auto with = [](auto member, auto value)
    {
        CameraParameters p;
        p.*member = value;
        return errorOf(p);
    };
    EXPECT_NE(with(&CameraParameters::width_px, 0).find("width_px"), std::string::npos);
    EXPECT_NE(with(&CameraParameters::height_px, -4).find("height_px"), std::string::npos);
    EXPECT_NE(with(&CameraParameters::fx_px, 0.0).find("fx_px"), std::string::npos);
    EXPECT_NE(with(&CameraParameters::fy_px, kNan).find("fy_px"), std::string::npos);
    EXPECT_NE(with(&CameraParameters::cx_px, kNan).find("cx_px"), std::string::npos);
    EXPECT_NE(with(&CameraParameters::cy_px, 1 / 0.0).find("cy_px"), std::string::npos);
    EXPECT_NE(with(&CameraParameters::readout_s, -0.01).find("readout_s"), std::string::npos);
    const std::string error = errorOf(cameraParameters(DistortionModel::Brown, {kNan}));
    EXPECT_NE(error.find("distortion"), std::string::npos);
}

TEST(Camera, RefusesADistortionThatFoldsInsideAQuarterDiagonal)
{
    using D = DistortionModel;
    EXPECT_NE(errorOf(cameraParameters(D::Brown, {-5.0})).find("folds"), std::string::npos);
    EXPECT_NE(errorOf(cameraParameters(D::Tsai, {-0.5, 0.0, 0.0056})).find("folds"),
              std::string::npos);
    EXPECT_NE(errorOf(cameraParameters(D::Davison, {1e-4})).find("folds"), std::string::npos);
    EXPECT_EQ(errorOf(cameraParameters(D::Brown, {-0.3})), "(no error)");
}
}  // namespace monoslam
