// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "exampleCameras.h"
#include "jacobianMatches.h"
#include "monoslam_models/InverseDepth.h"
#include "monoslam_models/projectLandmark.h"
#include "monoslam_models/quaternion.h"
#include "randomValues.h"

namespace monoslam
{
namespace
{
constexpr int kPoints = 120;

Vector6d randomLandmark(std::mt19937& rng)
{
    Vector6d y;
    y << uniformVector<3>(rng, 2.0), uniform(rng, -3.0, 3.0), uniform(rng, -1.3, 1.3),
        uniform(rng, 0.1, 2.0);
    return y;
}

Vector7d randomPose(std::mt19937& rng)
{
    Vector7d pose;
    pose << uniformVector<3>(rng, 2.0), randomQuaternion(rng);
    return pose;
}
}  // namespace

TEST(InverseDepth, RayAtZeroAnglesLooksForwardAndPositiveAnglesRightAndUp)
{
    EXPECT_LT((rayDirection(0, 0) - Eigen::Vector3d::UnitZ()).norm(), 1e-15);
    EXPECT_GT(rayDirection(0.1, 0).x(), 0);
    EXPECT_LT(rayDirection(0, 0.1).y(), 0);  // y points down
}

TEST(InverseDepth, AnglesOfARayAreThoseItWasMadeFrom)
{
    std::mt19937 rng(1);
    for (int i = 0; i < kPoints; ++i)
    {
        const Eigen::Vector2d angles(uniform(rng, -3.1, 3.1), uniform(rng, -1.5, 1.5));
        const Eigen::Vector3d m = rayDirection(angles[0], angles[1]);
        EXPECT_NEAR(m.norm(), 1.0, 1e-15);
        EXPECT_LT((rayAngles(uniform(rng, 0.1, 9.0) * m) - angles).norm(), 1e-12);
    }
}

TEST(InverseDepth, RayJacobiansMatchDifferences)
{
    std::mt19937 rng(2);
    for (int i = 0; i < kPoints; ++i)
    {
        const Eigen::Vector2d angles(uniform(rng, -3.0, 3.0), uniform(rng, -1.3, 1.3));
        Matrix32d J_m;
        const Eigen::Vector3d m = rayDirection(angles[0], angles[1], &J_m);
        EXPECT_TRUE(jacobianMatches(
            [](const Eigen::Vector2d& a) { return rayDirection(a[0], a[1]); }, angles, J_m, 1e-10));

        const Eigen::Vector3d g = uniform(rng, 0.5, 5.0) * m;
        Matrix23d J_angles;
        (void)rayAngles(g, &J_angles);
        EXPECT_TRUE(jacobianMatches([](const Eigen::Vector3d& x) { return rayAngles(x); }, g,
                                    J_angles, 1e-8));
    }
}

TEST(InverseDepth, PointLiesAtTheInverseDepthFromItsAnchorAndItsJacobianMatches)
{
    std::mt19937 rng(3);
    for (int i = 0; i < kPoints; ++i)
    {
        const Vector6d y = randomLandmark(rng);
        Matrix36d J;
        const Eigen::Vector3d p = toPoint(y, &J);
        EXPECT_NEAR((p - y.head<3>()).norm() * y[5], 1.0, 1e-13);
        EXPECT_TRUE(
            jacobianMatches([](const Vector6d& x) { return toPoint(x); }, y, J, 1e-7, 1e-3));
    }
}

TEST(InverseDepth, LinearityIndexIsThatOfTheFormulaAndFallsWithParallax)
{
    Vector6d y;
    y << 0, 0, 0, 0, 0, 0.5;  // a point 2 m ahead
    const double sigma_rho = 0.05;
    // seen from the anchor: 4 (0.05 / 0.25) / 2
    EXPECT_NEAR(linearityIndex(y, sigma_rho, Eigen::Vector3d::Zero()), 0.4, 1e-14);
    // from 2 m to the side: 45 degrees, distance sqrt(8)
    EXPECT_NEAR(linearityIndex(y, sigma_rho, {2, 0, 0}), 0.8 * std::sqrt(0.5) / std::sqrt(8.0),
                1e-14);
    EXPECT_NEAR(linearityIndex(y, sigma_rho, {5, 0, 2}), 0.0, 1e-14);
}

TEST(InverseDepth, NewLandmarkProjectsToItsPixelWhateverItsDepth)
{
    std::mt19937 rng(4);
    forEachCamera(
        [&](const Camera& camera)
        {
            for (const Eigen::Vector2d& uv : pixels(camera))
            {
                Vector13d x_v = Vector13d::Zero();
                x_v.head<7>() = randomPose(rng);
                const double rho0 = uniform(rng, 0, 3);
                const auto landmark = initializeUndelayed(camera, x_v.head<7>(), uv, rho0);
                ASSERT_TRUE(landmark);
                EXPECT_EQ(landmark->y[5], rho0);
                const auto h = projectPixel(camera, x_v, LandmarkKind::InverseDepth, landmark->y);
                ASSERT_TRUE(h);
                EXPECT_LT((*h - uv).norm(), 1e-9);
            }
        });
}

TEST(InverseDepth, NewLandmarkJacobiansMatchDifferences)
{
    std::mt19937 rng(5);
    forEachCamera(
        [&](const Camera& camera)
        {
            for (const Eigen::Vector2d& uv : pixels(camera))
            {
                const Vector7d pose = randomPose(rng);
                const auto landmark = initializeUndelayed(camera, pose, uv, 0.5);
                ASSERT_TRUE(landmark);
                if (std::abs(landmark->y[4]) > 1.3 || std::abs(landmark->y[3]) > 3.1) continue;
                const auto ofPose = [&](const Vector7d& x)
                { return initializeUndelayed(camera, x, uv, 0.5).value().y; };
                const auto ofPixel = [&](const Eigen::Vector3d& z)
                { return initializeUndelayed(camera, pose, z.head<2>(), z[2]).value().y; };
                const Eigen::Vector3d z(uv.x(), uv.y(), 0.5);
                EXPECT_TRUE(jacobianMatches(ofPose, pose, landmark->J_y_pose));
                EXPECT_TRUE(jacobianMatches(ofPixel, z, landmark->J_y_z, 1e-8, 1e-2));
            }
        });
}

TEST(InverseDepth, PixelWithoutARayMakesNoLandmark)
{
    const Camera camera(cameraParameters(DistortionModel::Brown, {-0.3}));
    const Vector7d pose = Vector7d::Unit(3);
    EXPECT_FALSE(initializeUndelayed(camera, pose, {1000, 242}, 0.5));
}
}  // namespace monoslam
