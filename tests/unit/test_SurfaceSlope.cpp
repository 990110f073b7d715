// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/SurfaceSlope.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "randomValues.h"

namespace monoslam
{
namespace
{
TEST(SurfaceSlope, ExpectsWhatItIsToldAsLongAsItHasLearntNothing)
{
    const SlopeEstimate estimate = SurfaceSlope().around({0.2, -0.1});
    EXPECT_LT((estimate.mean - Eigen::Vector2d(0.2, -0.1)).norm(), 1e-12);
    EXPECT_GT(estimate.information.determinant(), 0.0);
}

TEST(SurfaceSlope, ForgetsTheExpectationAlongWhatWasSeen)
{
    SurfaceSlope slope;
    Eigen::Matrix2d alongFirst = Eigen::Matrix2d::Zero();
    alongFirst(0, 0) = 1e4;
    slope.learn({Eigen::Vector2d(0.6, 0.0), alongFirst});
    const SlopeEstimate estimate = slope.around({-0.2, 0.3});
    EXPECT_NEAR(estimate.mean.x(), 0.6, 0.01);
    EXPECT_NEAR(estimate.mean.y(), 0.3, 1e-9);
}

TEST(SurfaceSlope, AveragesManyNoisyMeasurementsAndStaysUncertain)
{
    std::mt19937 rng(5);
    std::normal_distribution<double> normal;
    const Eigen::Vector2d truth(0.4, -0.5);
    SurfaceSlope slope;
    for (int i = 0; i < 2000; ++i)
    {
        const Eigen::Vector2d noisy = truth + 0.2 * Eigen::Vector2d(normal(rng), normal(rng));
        slope.learn({noisy, Eigen::Matrix2d::Identity() / 0.04});
    }
    EXPECT_LT((slope.around({0.0, 0.0}).mean - truth).norm(), 0.08);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(slope.information());
    EXPECT_LE(solver.eigenvalues()(1), 400.0 + 1e-6);
    EXPECT_GT(solver.eigenvalues()(0), 100.0);
}

TEST(AxesAcross, AreOrthonormalAndAcross)
{
    std::mt19937 rng(1);
    for (int i = 0; i < 100; ++i)
    {
        const Eigen::Vector3d ray = uniformVector<3>(rng, 1.0).normalized();
        const Eigen::Matrix<double, 3, 2> axes = axesAcross(ray);
        EXPECT_LT((axes.transpose() * axes - Eigen::Matrix2d::Identity()).norm(), 1e-12);
        EXPECT_LT((axes.transpose() * ray).norm(), 1e-12);
    }
}
}  // namespace
}  // namespace monoslam
