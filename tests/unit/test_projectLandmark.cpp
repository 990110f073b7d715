// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "exampleCameras.h"
#include "exampleLandmarks.h"
#include "jacobianMatches.h"
#include "monoslam_models/projectLandmark.h"
#include "monoslam_models/quaternion.h"
#include "randomValues.h"

namespace monoslam
{
namespace
{
using namespace camera_state;

constexpr LandmarkKind kKinds[] = {LandmarkKind::InverseDepth, LandmarkKind::Point};

/** Both Jacobians of projectLandmark at a state and a landmark. */
void expectJacobiansMatch(const Camera& camera, const Vector13d& x_v, LandmarkKind kind,
                          const Eigen::VectorXd& y)
{
    const std::optional<ProjectedLandmark> projected = projectLandmark(camera, x_v, kind, y);
    ASSERT_TRUE(projected);
    const auto ofState = [&](const Vector13d& x) { return projectLandmark(camera, x, kind, y)->h; };
    const auto ofLandmark = [&](const Eigen::VectorXd& l)
    { return projectLandmark(camera, x_v, kind, l)->h; };
    EXPECT_TRUE(jacobianMatches(ofState, x_v, projected->J_h_xv, 1e-6));
    EXPECT_TRUE(
        jacobianMatches(ofLandmark, y, projected->J_h_y.leftCols(landmarkSize(kind)), 1e-6));
}

Camera rollingCamera(double readout_s)
{
    CameraParameters p = cameraParameters(DistortionModel::Brown, {-0.28, 0.07, 1e-3, -5e-4});
    p.readout_s = readout_s;
    return Camera(p);
}
}  // namespace

TEST(ProjectLandmark, ReproducesTheGoldenVector)
{
    CameraParameters p{640, 480, 500, 510, 320, 240, {}, 0};
    Vector13d x_v = Vector13d::Zero();
    x_v.head<3>() << 0.25, 0.05, -0.2;
    x_v.segment<4>(kOrientation) = Eigen::Vector4d(0.995, 0.02, -0.06, 0.03).normalized();
    Vector6d y;
    y << 0.2, 0.1, -0.3, 0.15, -0.1, 0.4;
    const auto projected = projectLandmark(Camera(p), x_v, LandmarkKind::InverseDepth, y);
    ASSERT_TRUE(projected);
    Vector7d poseRow;
    poseRow << -223.481079, -15.167371, 32.397406, -70.251868, 65.885030, -1073.084370, 139.928200;
    Vector6d yRow0, yRow1;
    yRow0 << 223.481079, 15.167371, -32.397406, 561.712277, -37.388816, -17.939862;
    yRow1 << -9.690111, 223.739447, -27.085800, -13.765013, -563.599880, 35.950145;
    EXPECT_LT((projected->h - Eigen::Vector2d(455.867935, 321.217148)).norm(), 1e-6);
    EXPECT_LT((projected->J_h_xv.row(0).head<7>().transpose() - poseRow).norm(), 2e-6);
    EXPECT_LT((projected->J_h_y.row(0).transpose() - yRow0).norm(), 2e-6);
    EXPECT_LT((projected->J_h_y.row(1).transpose() - yRow1).norm(), 2e-6);
}

TEST(ProjectLandmark, JacobiansMatchDifferencesOverTheWholeImageOfEveryCamera)
{
    std::mt19937 rng(1);
    forEachCamera(
        [&](const Camera& camera)
        {
            for (const Eigen::Vector2d& uv : pixels(camera))
                for (const LandmarkKind kind : kKinds)
                {
                    const Vector13d x_v = randomState(rng);
                    expectJacobiansMatch(camera, x_v, kind, landmarkAt(rng, camera, x_v, kind, uv));
                }
        });
}

TEST(ProjectLandmark, IsRegularAtInfinityAndBeyond)
{
    std::mt19937 rng(2);
    const Camera camera(exampleCameras()[1]);
    for (int i = 0; i < 100; ++i)
    {
        const Vector13d x_v = randomState(rng);
        Eigen::VectorXd y = landmarkAt(rng, camera, x_v, LandmarkKind::InverseDepth, {320, 240});
        y.head<3>() = x_v.head<3>();
        for (const double rho : {0.0, 1e-9, -0.02})
        {
            y[5] = rho;
            expectJacobiansMatch(camera, x_v, LandmarkKind::InverseDepth, y);
        }
        y[5] = 0;  // at infinity the position of the camera does not count
        const auto projected = projectLandmark(camera, x_v, LandmarkKind::InverseDepth, y);
        EXPECT_EQ(projected->J_h_xv.leftCols<3>().norm(), 0);
    }
}

TEST(ProjectLandmark, SeesTheSamePixelInBothParameterisationsAndWithoutJacobians)
{
    std::mt19937 rng(3);
    const Camera camera(exampleCameras()[1]);
    for (const Eigen::Vector2d& uv : pixels(camera))
    {
        const Vector13d x_v = randomState(rng);
        const LandmarkKind kind = LandmarkKind::InverseDepth;
        const Vector6d y = landmarkAt(rng, camera, x_v, kind, uv);
        const Eigen::Vector2d h = projectLandmark(camera, x_v, kind, y)->h;
        EXPECT_LT((h - uv).norm(), 1e-9);
        EXPECT_LT((projectLandmark(camera, x_v, LandmarkKind::Point, toPoint(y))->h - h).norm(),
                  1e-9);
        EXPECT_LT((*projectPixel(camera, x_v, kind, y) - h).norm(), 1e-12);
    }
}

TEST(ProjectLandmark, DoesNotChangeWhenTheWholeWorldMoves)
{
    std::mt19937 rng(4);
    const Camera camera = rollingCamera(0.02);
    const Eigen::Vector3d t = uniformVector<3>(rng, 5.0);
    const Eigen::Vector4d q = randomQuaternion(rng);
    for (const Eigen::Vector2d& uv : pixels(camera))
    {
        const Vector13d x_v = randomState(rng);
        const Eigen::Vector3d p = landmarkAt(rng, camera, x_v, LandmarkKind::Point, uv);
        Vector13d moved = x_v;
        moved.head<3>() = t + rotate(q, x_v.head<3>());
        moved.segment<4>(kOrientation) = quaternionProduct(q, x_v.segment<4>(kOrientation));
        moved.segment<3>(kVelocity) = rotate(q, x_v.segment<3>(kVelocity));
        const auto h = projectPixel(camera, x_v, LandmarkKind::Point, p);
        const Eigen::Vector3d movedPoint = t + rotate(q, p);
        const auto hMoved = projectPixel(camera, moved, LandmarkKind::Point, movedPoint);
        ASSERT_TRUE(h && hMoved);
        EXPECT_LT((*h - *hMoved).norm(), 1e-8);
    }
}

TEST(ProjectLandmark, SeesNothingBehindTheCamera)
{
    const Vector13d x_v = Vector13d::Unit(kOrientation);
    const Eigen::Vector3d p(0.1, 0.2, -1.0);
    for (const double readout_s : {0.0, 0.02})
    {
        const Camera camera = rollingCamera(readout_s);
        EXPECT_FALSE(projectLandmark(camera, x_v, LandmarkKind::Point, p));
        EXPECT_FALSE(projectPixel(camera, x_v, LandmarkKind::Point, p));
    }
}

TEST(ProjectLandmark, RollingShutterSeesTheLandmarkFromThePoseOfItsOwnRow)
{
    std::mt19937 rng(5);
    const double readout_s = 0.03;
    const Camera rolling = rollingCamera(readout_s), global = rollingCamera(0);
    for (const Eigen::Vector2d& uv : pixels(rolling))
    {
        const Vector13d x_v = randomState(rng);
        const Eigen::VectorXd y = landmarkAt(rng, global, x_v, LandmarkKind::Point, uv);
        const auto h = projectPixel(rolling, x_v, LandmarkKind::Point, y);
        ASSERT_TRUE(h);
        const double s = (h->y() / rolling.parameters().height_px - 0.5) * readout_s;
        Vector13d atRow = x_v;
        atRow.head<3>() += s * x_v.segment<3>(kVelocity);
        atRow.segment<4>(kOrientation) = quaternionProduct(
            x_v.segment<4>(kOrientation), quaternionExp(s * x_v.segment<3>(kAngularVelocity)));
        EXPECT_LT((*projectPixel(global, atRow, LandmarkKind::Point, y) - *h).norm(), 1e-8);
    }
}

TEST(ProjectLandmark, RollingShutterJacobiansReachTheVelocities)
{
    std::mt19937 rng(6);
    const Camera rolling = rollingCamera(0.03), global = rollingCamera(0);
    for (const Eigen::Vector2d& uv : pixels(rolling))
        for (const LandmarkKind kind : kKinds)
        {
            const Vector13d x_v = randomState(rng);
            const Eigen::VectorXd y = landmarkAt(rng, global, x_v, kind, uv);
            if (!projectPixel(rolling, x_v, kind, y)) continue;
            expectJacobiansMatch(rolling, x_v, kind, y);
        }
}

TEST(ProjectLandmark, RollingShutterOfACameraAtRestIsGlobal)
{
    std::mt19937 rng(7);
    Vector13d x_v = randomState(rng);
    x_v.tail<6>().setZero();
    const Camera rolling = rollingCamera(0.03), global = rollingCamera(0);
    const Eigen::VectorXd y = landmarkAt(rng, global, x_v, LandmarkKind::InverseDepth, {100, 50});
    const auto a = projectLandmark(rolling, x_v, LandmarkKind::InverseDepth, y);
    const auto b = projectLandmark(global, x_v, LandmarkKind::InverseDepth, y);
    EXPECT_LT((a->h - b->h).norm(), 1e-12);
    EXPECT_LT((a->J_h_xv.leftCols<7>() - b->J_h_xv.leftCols<7>()).norm(), 1e-10);
}
}  // namespace monoslam
