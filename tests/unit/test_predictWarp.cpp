// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/predictWarp.h"

#include <gtest/gtest.h>

#include "monoslam_vision/searchPatch.h"
#include "renderPlane.h"
#include "texture.h"

namespace monoslam
{
namespace
{
constexpr double kPixelsPerMetre = 400.0;

/** A plane with a texture of about one texture pixel a picture pixel, through the origin. */
PaintedPlane planeFacing(const Eigen::Vector3d& normal)
{
    static const Texture texture(11, 25.0);
    PaintedPlane plane;
    plane.light = [](double x, double y)
    { return std::clamp(texture.at(kPixelsPerMetre * x, kPixelsPerMetre * y) / 255.0, 0.0, 1.0); };
    plane.R_wp =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal).toRotationMatrix();
    return plane;
}

Camera smallCamera(double fx_px)
{
    CameraParameters p;
    p.width_px = 120;
    p.height_px = 100;
    p.fx_px = p.fy_px = fx_px;
    p.cx_px = 59.5;
    p.cy_px = 49.5;
    p.distortion.model = DistortionModel::Brown;
    p.distortion.k = {-0.2, 0.05, 1e-3, -5e-4, 0, 0, 0, 0};
    return Camera(p);
}

Eigen::Vector3d onCircle(double angle_deg, double distance)
{
    const double a = angle_deg * M_PI / 180.0;
    return distance * Eigen::Vector3d(std::sin(a), 0.1, std::cos(a)).normalized();
}

Appearance born(const PaintedPlane& plane, const Camera& camera, const Vector7d& pose)
{
    Sensor sensor;
    sensor.srgb = false;
    Appearance appearance;
    appearance.image = prepareImage(renderPlane(plane, camera, pose, sensor), 0.7);
    appearance.uv_px = *camera.project(rotateInverse(pose.tail<4>(), -pose.head<3>()));
    appearance.pose = pose;
    return appearance;
}

/** ZNCC at the pixel now of a patch born from pose `then`. */
double score(const PaintedPlane& plane, const Camera& camera, const Vector7d& then,
             const Vector7d& now, bool warped)
{
    const Appearance first = born(plane, camera, then);
    const Appearance second = born(plane, camera, now);
    const auto warp = predictWarp(camera, first, now, Eigen::Vector3d::Zero(), {});
    if (!warp) return -1.0;
    const PredictedWarp used = warped ? *warp : PredictedWarp{};
    const auto patch = samplePatch(first, used, 6);
    if (!patch) return -1.0;
    PatchSearchRegion region;
    region.centre_px = second.uv_px;
    region.S.setIdentity();
    region.gate = 2.0;
    region.minScore = -1.0;
    const PatchSearch found = searchPatch(*second.image, *patch, region);
    return found.peaks.empty() ? -1.0 : found.peaks.front().score;
}

TEST(PredictWarp, IsTheIdentityForTheSameView)
{
    const Camera camera = smallCamera(200);
    Appearance first;
    first.uv_px = {70, 40};
    first.pose = lookAt(onCircle(0, 0.5), Eigen::Vector3d::Zero());
    const Eigen::Vector3d ray = *camera.unproject(first.uv_px);
    const Eigen::Vector3d p_w =
        rotationMatrix(first.pose.tail<4>()) * ray * 0.7 + first.pose.head<3>();
    const auto warp = predictWarp(camera, first, first.pose, p_w, {});
    ASSERT_TRUE(warp);
    EXPECT_LT((warp->M - Eigen::Matrix2d::Identity()).norm(), 1e-6);
}

TEST(PredictWarp, TurnsWithTheCamera)
{
    const Camera camera = smallCamera(200);
    Appearance first;
    first.uv_px = {59.5, 49.5};
    first.pose = lookAt({0, 0, 0.5}, Eigen::Vector3d::Zero());
    const double roll = 0.4;
    const Vector7d now = lookAt({0, 0, 0.5}, Eigen::Vector3d::Zero(), roll);
    const auto warp = predictWarp(camera, first, now, Eigen::Vector3d::Zero(), {});
    ASSERT_TRUE(warp);
    EXPECT_NEAR(warp->M.determinant(), 1.0, 0.01);
    EXPECT_NEAR(std::abs(warp->M(0, 1)), std::sin(roll), 0.01);
    EXPECT_NEAR(warp->M(0, 0), std::cos(roll), 0.01);
}

TEST(PredictWarp, PredictsAPlaneSeen30DegreesAside)
{
    const Camera camera = smallCamera(200);
    const PaintedPlane plane = planeFacing(Eigen::Vector3d::UnitZ());
    const Vector7d then = lookAt(onCircle(-15, 0.5), Eigen::Vector3d::Zero());
    const Vector7d now = lookAt(onCircle(15, 0.5), Eigen::Vector3d::Zero(), 0.3);
    const double warped = score(plane, camera, then, now, true);
    EXPECT_GT(warped, 0.95);
    EXPECT_LT(score(plane, camera, then, now, false), warped - 0.05);
}

TEST(PredictWarp, PredictsTheSizeFromNearAndFar)
{
    const Camera camera = smallCamera(200);
    const PaintedPlane plane = planeFacing(Eigen::Vector3d::UnitZ());
    const Vector7d far = lookAt(onCircle(0, 0.75), Eigen::Vector3d::Zero());
    const Vector7d near = lookAt(onCircle(0, 0.45), Eigen::Vector3d::Zero());
    EXPECT_GT(score(plane, camera, near, far, true), 0.9);
    EXPECT_GT(score(plane, camera, far, near, true), 0.9);
    EXPECT_LT(score(plane, camera, near, far, false), 0.85);
}

TEST(PredictWarp, RefusesWhatHasChangedTooMuch)
{
    const Camera camera = smallCamera(200);
    Appearance first;
    first.uv_px = {59.5, 49.5};
    first.pose = lookAt({0, 0, 0.5}, Eigen::Vector3d::Zero());
    const auto from = [&](const Eigen::Vector3d& r)
    {
        return predictWarp(camera, first, lookAt(r, Eigen::Vector3d::Zero()),
                           Eigen::Vector3d::Zero(), {})
            .has_value();
    };
    EXPECT_TRUE(from({0, 0, 0.9}));
    EXPECT_FALSE(from({0, 0, 1.1}));
    EXPECT_TRUE(from({0, 0, 0.3}));
    EXPECT_FALSE(from({0, 0, 0.2}));
    EXPECT_TRUE(from(0.5 * Eigen::Vector3d(std::sin(0.75), 0, std::cos(0.75))));
    EXPECT_FALSE(from(0.5 * Eigen::Vector3d(std::sin(0.85), 0, std::cos(0.85))));
    EXPECT_FALSE(from({0, 0, -0.5}));
}

TEST(PredictWarp, FollowsTheSlopeThatItHasLearnt)
{
    const Camera camera = smallCamera(200);
    const Vector7d then = lookAt(onCircle(-12, 0.5), Eigen::Vector3d::Zero());
    const Vector7d now = lookAt(onCircle(14, 0.5), Eigen::Vector3d(0.01, 0.0, 0.0), 0.3);
    std::mt19937 rng(3);
    for (int i = 0; i < 100; ++i)
    {
        Appearance first;
        first.uv_px = Eigen::Vector2d(59.5, 49.5) + uniformVector<2>(rng, 20.0);
        first.pose = then;
        const Eigen::Vector3d p_w =
            rotate(then.tail<4>(), *camera.unproject(first.uv_px) * 0.5) + then.head<3>();
        const auto withSlope = [&](const Eigen::Vector2d& s)
        {
            Appearance learnt = first;
            learnt.slope.learn({s, 1e12 * Eigen::Matrix2d::Identity()});
            return predictWarp(camera, learnt, now, p_w, {});
        };
        const Eigen::Vector2d s = uniformVector<2>(rng, 0.4);
        const auto warp = withSlope(s);
        ASSERT_TRUE(warp);
        for (Eigen::Index k = 0; k < 2; ++k)
        {
            const Eigen::Vector2d step = 1e-3 * Eigen::Vector2d::Unit(k);
            const auto plus = withSlope(warp->slope.mean + step);
            const auto minus = withSlope(warp->slope.mean - step);
            const Eigen::Vector2d change = plus->slope.mean - minus->slope.mean;
            const Eigen::Matrix2d expected =
                warp->J_M_s[0] * change(0) + warp->J_M_s[1] * change(1);
            EXPECT_LT((plus->M - minus->M - expected).norm(), 0.02 * expected.norm());
        }
    }
}
}  // namespace
}  // namespace monoslam
