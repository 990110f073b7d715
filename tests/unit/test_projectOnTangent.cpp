// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_models/projectOnTangent.h"

#include <gtest/gtest.h>

#include "jacobianMatches.h"
#include "monoslam_models/InverseDepth.h"
#include "monoslam_models/quaternion.h"
#include "randomValues.h"

namespace monoslam
{
namespace
{
Vector7d randomPose(std::mt19937& rng)
{
    Vector7d pose;
    pose << uniformVector<3>(rng, 0.3), quaternionExp(uniformVector<3>(rng, 0.2));
    return pose;
}

/** An inverse-depth landmark ahead (6 numbers), down to rho = 0, or a point (3 numbers). */
Eigen::VectorXd landmarkAhead(LandmarkKind kind, double rho, std::mt19937& rng)
{
    if (kind == LandmarkKind::Point)
        return Eigen::Vector3d(0.0, 0.0, 2.0) + uniformVector<3>(rng, 0.5);
    Vector6d y;
    y << uniformVector<3>(rng, 0.2), uniformVector<2>(rng, 0.2), rho;
    return y;
}

TEST(ProjectOnTangent, GivesThePixelOfProjectLandmark)
{
    const Camera camera;
    std::mt19937 rng(1);
    for (int i = 0; i < 200; ++i)
    {
        const auto kind = i % 2 == 0 ? LandmarkKind::InverseDepth : LandmarkKind::Point;
        const Vector7d pose = randomPose(rng);
        const Eigen::VectorXd y = landmarkAhead(kind, i % 10 == 0 ? 0.0 : 0.6, rng);
        Vector13d x_v = Vector13d::Zero();
        x_v.head<7>() = pose;
        const auto expected = projectPixel(camera, x_v, kind, y);
        const auto projected = projectOnTangent(camera, ViewPose(pose), LandmarkRay(kind, y));
        ASSERT_TRUE(expected && projected);
        EXPECT_LT((projected->h - *expected).norm(), 1e-9);
        EXPECT_EQ(projectRay(camera, ViewPose(pose), LandmarkRay(kind, y)), projected->h);
    }
}

TEST(ProjectOnTangent, JacobiansMatchDifferences)
{
    const Camera camera;
    std::mt19937 rng(2);
    for (int i = 0; i < 200; ++i)
    {
        const auto kind = i % 2 == 0 ? LandmarkKind::InverseDepth : LandmarkKind::Point;
        const Vector7d pose = randomPose(rng);
        const Eigen::VectorXd y = landmarkAhead(kind, i % 10 == 0 ? 0.0 : 0.6, rng);
        const auto at = [&](const Eigen::VectorXd& d) -> Eigen::VectorXd
        {
            Vector7d moved = pose;
            moved.head<3>() += d.head<3>();
            moved.tail<4>() =
                quaternionProduct(pose.tail<4>(), quaternionExp(Eigen::Vector3d(d.segment<3>(3))));
            Eigen::VectorXd landmark = y;
            landmark.tail<3>() += d.tail<3>();
            return *projectRay(camera, ViewPose(moved), LandmarkRay(kind, landmark));
        };
        const auto projected = projectOnTangent(camera, ViewPose(pose), LandmarkRay(kind, y));
        ASSERT_TRUE(projected);
        Eigen::MatrixXd J(2, 9);
        J << projected->J_h_pose, projected->J_h_landmark;
        EXPECT_TRUE(jacobianMatches(at, Eigen::VectorXd::Zero(9), J));
    }
}

TEST(ProjectOnTangent, GivesNothingBehindTheCamera)
{
    const Camera camera;
    Vector7d pose;
    pose << 0.0, 0.0, 5.0, 1.0, 0.0, 0.0, 0.0;
    const LandmarkRay point(LandmarkKind::Point, Eigen::Vector3d(0.0, 0.0, 2.0));
    EXPECT_FALSE(projectOnTangent(camera, ViewPose(pose), point));
    EXPECT_FALSE(projectRay(camera, ViewPose(pose), point));
}
}  // namespace
}  // namespace monoslam
