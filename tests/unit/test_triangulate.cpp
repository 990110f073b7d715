// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "exampleCameras.h"
#include "jacobianMatches.h"
#include "monoslam_models/quaternion.h"
#include "monoslam_models/triangulate.h"
#include "randomValues.h"

namespace monoslam
{
namespace
{
using Vector9d = Eigen::Matrix<double, 9, 1>;

Camera smallCamera()
{
    CameraParameters p;
    p.width_px = 424;
    p.height_px = 240;
    p.fx_px = p.fy_px = 300;
    p.cx_px = 212;
    p.cy_px = 120;
    return Camera(p);
}

/** The view of a world point from a pose. */
View viewOf(const Camera& camera, const Vector7d& pose, const Eigen::Vector3d& p)
{
    const Eigen::Vector3d h_c = rotateInverse(pose.tail<4>(), p - pose.head<3>());
    return {pose, camera.project(h_c).value()};
}

struct Scene
{
    Eigen::Vector3d p;
    View first, current;
};

Scene goldenScene(const Camera& camera)
{
    Vector7d first = Vector7d::Unit(3), current;
    current << 0.25, 0.03, 0.05, Eigen::Vector4d(0.999, 0.01, -0.03, 0.02).normalized();
    const Eigen::Vector3d p(0.3, -0.1, 2);
    return {p, viewOf(camera, first, p), viewOf(camera, current, p)};
}

/** A point ahead, two nearby poses that see it; the quaternions are not quite normalised. */
Scene randomScene(std::mt19937& rng, const Camera& camera)
{
    const Eigen::Vector4d q = randomQuaternion(rng);
    const Eigen::Vector3d r = uniformVector<3>(rng, 3.0);
    const Eigen::Vector3d inCamera(uniform(rng, -0.4, 0.4), uniform(rng, -0.3, 0.3), 2.0);
    Vector7d first, current;
    const Eigen::Vector4d dq = quaternionExp(uniformVector<3>(rng, 0.1));
    Eigen::Vector3d B = uniformVector<3>(rng, 0.5);
    B.x() += B.x() < 0 ? -0.2 : 0.2;
    first << r, 1.01 * q;
    current << r + rotate(q, B), 0.98 * quaternionProduct(q, dq);
    const Eigen::Vector3d p = r + rotate(q, inCamera);
    return {p, viewOf(camera, first, p), viewOf(camera, current, p)};
}

View viewFrom(const Vector9d& a)
{
    return {a.head<7>(), a.tail<2>()};
}

Vector9d stacked(const View& view)
{
    Vector9d a;
    a << view.pose, view.uv_px;
    return a;
}
}  // namespace

TEST(Triangulate, ReproducesTheGoldenVector)
{
    const Camera camera = smallCamera();
    const Scene scene = goldenScene(camera);
    const auto t = triangulate(camera, scene.first, scene.current);
    ASSERT_TRUE(t);
    EXPECT_NEAR(t->alpha_rad / kDegree, 7.118066, 1e-6);
    EXPECT_NEAR(t->beta_rad / kDegree, 70.676726, 1e-6);
    EXPECT_NEAR(t->gamma_rad / kDegree, 102.205208, 1e-6);
    EXPECT_NEAR(t->baseline, 0.256709953, 1e-9);
    EXPECT_NEAR(t->y[inverse_depth::kTheta], 0.025635409, 1e-9);
    EXPECT_NEAR(t->y[inverse_depth::kPhi], 0.066546356, 1e-9);
    EXPECT_NEAR(t->y[inverse_depth::kRho], 0.511517316, 1e-9);
    EXPECT_LT(t->epipolarResidual_rad, 1e-12);
    const double sigma_rho = std::hypot(t->J_current.bottomRightCorner<1, 2>().norm(),
                                        t->J_first.bottomRightCorner<1, 2>().norm());
    EXPECT_NEAR(sigma_rho / t->y[inverse_depth::kRho], 0.0380011, 1e-6);
}

TEST(Triangulate, FindsTheTruePointAnchoredAtTheCurrentCamera)
{
    std::mt19937 rng(1);
    forEachCamera(
        [&](const Camera& camera)
        {
            for (int i = 0; i < 100; ++i)
            {
                const Scene scene = randomScene(rng, camera);
                const auto t = triangulate(camera, scene.first, scene.current);
                ASSERT_TRUE(t);
                EXPECT_EQ(t->y.head<3>(), scene.current.pose.head<3>());
                EXPECT_LT((toPoint(t->y) - scene.p).norm(), 1e-8);
                EXPECT_LT(t->epipolarResidual_rad, 1e-9);
            }
        });
}

TEST(Triangulate, JacobiansMatchDifferencesAlsoWhenTheRaysDoNotMeet)
{
    std::mt19937 rng(2);
    for (const int index : {0, 1, 4})
    {
        const Camera camera(exampleCameras()[static_cast<std::size_t>(index)]);
        for (int i = 0; i < 120; ++i)
        {
            Scene scene = randomScene(rng, camera);
            scene.first.uv_px += uniformVector<2>(rng, 1.5);
            const auto t = triangulate(camera, scene.first, scene.current);
            if (!t || t->alpha_rad < 2 * kDegree || std::abs(t->y[4]) > 1.3) continue;
            const auto ofCurrent = [&](const Vector9d& a)
            { return triangulate(camera, scene.first, viewFrom(a)).value().y; };
            const auto ofFirst = [&](const Vector9d& a)
            { return triangulate(camera, viewFrom(a), scene.current).value().y; };
            EXPECT_TRUE(jacobianMatches(ofCurrent, stacked(scene.current), t->J_current, 1e-6));
            EXPECT_TRUE(jacobianMatches(ofFirst, stacked(scene.first), t->J_first, 1e-6));
        }
    }
}

TEST(Triangulate, PredictsTheSpreadOfRhoUnderPixelNoise)
{
    const Camera camera = smallCamera();
    const Scene scene = goldenScene(camera);
    const auto t = triangulate(camera, scene.first, scene.current);
    const double sigma_px = 0.3;
    const double predicted = sigma_px * std::hypot(t->J_current.bottomRightCorner<1, 2>().norm(),
                                                   t->J_first.bottomRightCorner<1, 2>().norm());
    std::mt19937 rng(3);
    constexpr int kSamples = 20000;
    double sum = 0;
    for (int i = 0; i < kSamples; ++i)
    {
        View first = scene.first, current = scene.current;
        first.uv_px += normalVector<2>(rng, sigma_px);
        current.uv_px += normalVector<2>(rng, sigma_px);
        const double rho = triangulate(camera, first, current).value().y[inverse_depth::kRho];
        sum += std::pow(rho - t->y[inverse_depth::kRho], 2);
    }
    EXPECT_NEAR(std::sqrt(sum / kSamples) / predicted, 1.0, 0.03);
}

TEST(Triangulate, MeasuresHowFarTheRaysMissEachOther)
{
    const Camera camera = smallCamera();
    const Vector7d first = Vector7d::Unit(3);
    Vector7d current = first;
    current[0] = 0.3;  // sideways: the epipolar lines are rows
    const Eigen::Vector3d p(0.15, 0, 2);
    View second = viewOf(camera, current, p);
    second.uv_px.y() += 3.0;
    const auto t = triangulate(camera, viewOf(camera, first, p), second);
    ASSERT_TRUE(t);
    EXPECT_NEAR(t->epipolarResidual_rad, 3.0 / 300, 1e-4);
}

TEST(Triangulate, GivesNothingWithoutBaselineOrForDivergingRays)
{
    const Camera camera = smallCamera();
    Vector7d first = Vector7d::Unit(3), current = first;
    const Eigen::Vector3d p(0.2, 0.1, 2);
    EXPECT_FALSE(triangulate(camera, viewOf(camera, first, p), viewOf(camera, current, p)));

    current[0] = 0.3;
    View second = viewOf(camera, current, p);
    second.uv_px.x() += 60;  // as if the point had moved along with more than the camera
    EXPECT_FALSE(triangulate(camera, viewOf(camera, first, p), second));

    current << 0.2, 0.1, 1.0, 1, 0, 0, 0;
    first[0] = 0.2;
    first[1] = 0.1;  // straight towards the point: parallel to B
    EXPECT_FALSE(triangulate(camera, viewOf(camera, first, p), viewOf(camera, current, p)));
}
}  // namespace monoslam
