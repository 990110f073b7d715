// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <random>

#include "monoslam_association/informationGain.h"
#include "monoslam_models/quaternion.h"

namespace monoslam::test
{
namespace
{
using Eigen::MatrixXd;

MatrixXd draw(Eigen::Index rows, Eigen::Index columns, std::mt19937& rng)
{
    std::normal_distribution<double> normal;
    return MatrixXd::NullaryExpr(rows, columns, [&]() { return normal(rng); });
}

MatrixXd drawCovariance(Eigen::Index n, std::mt19937& rng)
{
    const MatrixXd A = draw(n, n, rng);
    return A * A.transpose() + 0.1 * MatrixXd::Identity(n, n);
}

/** A pose, its covariance with the null direction along q, and some covariances with pixels. */
struct PoseAndPixels
{
    Vector7d pose;
    MatrixXd P_ee;  ///< of (dr, dtheta, z), 8 x 8, regular
    Eigen::Matrix<double, 7, 7> P_xx;
    Eigen::Matrix<double, 7, 2> C;
    Eigen::Matrix2d S;

    explicit PoseAndPixels(std::mt19937& rng)
    {
        pose = draw(7, 1, rng);
        pose.tail<4>().normalize();
        P_ee = drawCovariance(8, rng);
        // q = q0 (x) (1, dtheta / 2): the inverse of the error basis on the tangent space.
        MatrixXd E = MatrixXd::Zero(7, 6);
        E.topLeftCorner(3, 3).setIdentity();
        for (int k = 0; k < 3; ++k)
        {
            Eigen::Vector4d half = Eigen::Vector4d::Zero();
            half(k + 1) = 0.5;
            E.block<4, 1>(3, 3 + k) = quaternionProduct(pose.tail<4>(), half);
        }
        P_xx = E * P_ee.topLeftCorner(6, 6) * E.transpose();
        C = E * P_ee.topRightCorner(6, 2);
        S = P_ee.bottomRightCorner(2, 2);
    }
};
}  // namespace

TEST(InformationAboutState, EqualsTheLiteralDeterminantsOfARegularCovariance)
{
    std::mt19937 rng(1);
    for (int i = 0; i < 200; ++i)
    {
        const MatrixXd P = drawCovariance(9, rng), H = draw(2, 9, rng);
        const Eigen::Matrix2d R = drawCovariance(2, rng);
        const Eigen::Matrix2d S = H * P * H.transpose() + R;
        const MatrixXd K = P * H.transpose() * S.inverse();
        const MatrixXd posterior = P - K * S * K.transpose();
        const double literal = 0.5 * std::log2(P.determinant() / posterior.determinant());
        EXPECT_NEAR(informationAboutState(S, R), literal, 1e-9 * (1.0 + literal));
    }
}

TEST(InformationAboutState, IsNothingWithoutAPositiveDeterminant)
{
    const Eigen::Matrix2d I = Eigen::Matrix2d::Identity();
    EXPECT_EQ(informationAboutState(I, I), 0.0);
    EXPECT_EQ(informationAboutState(Eigen::Matrix2d::Zero(), I), 0.0);
    EXPECT_EQ(informationAboutState(I, Eigen::Matrix2d::Zero()), 0.0);
    EXPECT_DOUBLE_EQ(informationAboutState(4.0 * I, I), 2.0);
}

TEST(PoseInformation, EqualsTheLiteralDeterminantsOfTheSixDimensionalError)
{
    std::mt19937 rng(2);
    for (int i = 0; i < 200; ++i)
    {
        const PoseAndPixels sample(rng);
        const double pose = sample.P_ee.topLeftCorner(6, 6).determinant();
        const double literal =
            0.5 * std::log2(pose * sample.S.determinant() / sample.P_ee.determinant());
        const PoseInformation information(sample.pose, sample.P_xx);
        EXPECT_NEAR(information(sample.C, sample.S), literal, 1e-8 * (1.0 + literal));
    }
}

TEST(PoseInformation, IgnoresUnitsAndDirectionsWithoutVariance)
{
    std::mt19937 rng(3);
    PoseAndPixels sample(rng);
    const double before = PoseInformation(sample.pose, sample.P_xx)(sample.C, sample.S);
    Vector7d unit = Vector7d::Ones();
    unit.head<3>().setConstant(1e-5);
    sample.P_xx = unit.asDiagonal() * sample.P_xx * unit.asDiagonal();
    sample.C = unit.asDiagonal() * sample.C;
    EXPECT_NEAR(PoseInformation(sample.pose, sample.P_xx)(sample.C, sample.S), before, 1e-8);
    sample.P_xx.topRows<3>().setZero();
    sample.P_xx.leftCols<3>().setZero();
    sample.C.topRows<3>().setZero();
    const double known = PoseInformation(sample.pose, sample.P_xx)(sample.C, sample.S);
    EXPECT_TRUE(std::isfinite(known));
    EXPECT_GT(known, 0.0);
    EXPECT_LE(known, before + 1e-9);
    sample.P_xx.setZero();
    sample.C.setZero();
    EXPECT_EQ(PoseInformation(sample.pose, sample.P_xx)(sample.C, sample.S), 0.0);
}

TEST(PoseInformation, NeverExceedsWhatThePixelTellsOfTheState)
{
    std::mt19937 rng(4);
    for (int i = 0; i < 100; ++i)
    {
        // Pose and one landmark number are all of the state: z = A (pose error) + b (landmark) + n.
        PoseAndPixels sample(rng);
        const Eigen::Matrix2d S = sample.S;
        const Eigen::Matrix2d given =
            S - sample.P_ee.bottomLeftCorner(2, 6) *
                    sample.P_ee.topLeftCorner(6, 6).ldlt().solve(sample.P_ee.topRightCorner(6, 2));
        const Eigen::Matrix2d R = 0.5 * given;
        EXPECT_LT(PoseInformation(sample.pose, sample.P_xx)(sample.C, S),
                  informationAboutState(S, R));
    }
}
}  // namespace monoslam::test
