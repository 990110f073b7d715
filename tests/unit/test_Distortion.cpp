// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "exampleCameras.h"
#include "monoslam_models/Distortion.h"

namespace monoslam
{
namespace
{
double maxAngleOf(DistortionModel model, std::array<double, 8> k)
{
    return maxAngle({model, k}, {400.0, 400.0});
}

}  // namespace

TEST(Distortion, FindsTheLargestValidAngleInClosedForms)
{
    using D = DistortionModel;
    EXPECT_NEAR(maxAngleOf(D::None, {}), 89 * kDegree, 1e-12);
    EXPECT_NEAR(maxAngleOf(D::Brown, {0.2}), 89 * kDegree, 1e-12);
    EXPECT_NEAR(maxAngleOf(D::Brown, {-0.3}), std::atan(1 / std::sqrt(0.9)), 1e-12);
    // 1 + k4 r^2 vanishes at r = 2
    EXPECT_NEAR(maxAngleOf(D::Brown, {0, 0, 0, 0, 0, -0.25}), std::atan(2.0), 1e-12);
    EXPECT_NEAR(maxAngleOf(D::KannalaBrandt, {-0.2}), 1 / std::sqrt(0.6), 1e-12);
    EXPECT_NEAR(maxAngleOf(D::KannalaBrandt, {0.05, -0.02, 0.01, -0.002}), 89 * kDegree, 1e-12);
    // Tsai: 1 + 3 k1 rd^2 = 0 at rd = 1 mm = 500 px, where c = 2/3 of that
    EXPECT_NEAR(maxAngleOf(D::Tsai, {-1.0 / 3, 0, 0.002}), std::atan(2.0 / 3 * 500 / 400), 1e-12);
    EXPECT_NEAR(maxAngleOf(D::Tsai, {0.063, 0.0139, 0.0056}), 89 * kDegree, 1e-12);
    EXPECT_NEAR(maxAngleOf(D::Davison, {9e-6}), 89 * kDegree, 1e-12);
    EXPECT_NEAR(maxAngleOf(D::Davison, {-5e-6}), std::atan(std::sqrt(1e5) / 400), 1e-12);
}

TEST(Distortion, HasTheDirectionAndUnitsOfItsSource)
{
    const FocalLengths f{300, 300};
    // Davison bends towards the centre by sqrt(1 + 2 K1 c^2), c = 100 px
    const DistortionParameters davison{DistortionModel::Davison, {9e-6}};
    EXPECT_NEAR(distort(davison, f, {1.0 / 3, 0})->x() * 300, 100 / std::sqrt(1.18), 1e-12);
    // Tsai's polynomial starts from the distorted pixel: p = 100 px = 1 mm
    const DistortionParameters tsai{DistortionModel::Tsai, {0.06, 0.01, 0.01}};
    EXPECT_NEAR(undistort(tsai, f, {0, 1.0 / 3})->y() * 300, 107.0, 1e-12);
    EXPECT_NEAR(distort(tsai, f, {0, 107.0 / 300})->y() * 300, 100.0, 1e-10);
}

TEST(Distortion, RoundTripsThroughEveryJacobianProduct)
{
    std::mt19937 rng(4);
    forEachCamera(
        [&](const Camera& camera)
        {
            const CameraParameters& p = camera.parameters();
            for (int i = 0; i < 100; ++i)
            {
                const Eigen::Vector2d x_n = pointInView(rng, camera, 0.9).hnormalized();
                Eigen::Matrix2d J_xd_xn, J_xn_xd;
                const auto x_d = distort(p.distortion, {p.fx_px, p.fy_px}, x_n, &J_xd_xn);
                ASSERT_TRUE(x_d);
                const auto back = undistort(p.distortion, {p.fx_px, p.fy_px}, *x_d, &J_xn_xd);
                ASSERT_TRUE(back);
                EXPECT_LT((*back - x_n).norm(), 1e-11);
                EXPECT_LT((J_xd_xn * J_xn_xd - Eigen::Matrix2d::Identity()).norm(), 1e-9);
            }
        });
}
}  // namespace monoslam
