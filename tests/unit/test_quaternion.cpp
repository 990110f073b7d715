// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "jacobianMatches.h"
#include "monoslam_models/quaternion.h"
#include "randomValues.h"

namespace monoslam
{
namespace
{
constexpr int kPoints = 120;
constexpr double kPi = 3.14159265358979323846;

Eigen::Quaterniond toEigen(const Eigen::Vector4d& q)
{
    return Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
}
}  // namespace

TEST(Quaternion, RotatesAsEigenDoes)
{
    std::mt19937 rng(1);
    for (int i = 0; i < kPoints; ++i)
    {
        const Eigen::Vector4d q = randomQuaternion(rng);
        const Eigen::Vector3d a = uniformVector<3>(rng, 5.0);
        EXPECT_LT((rotationMatrix(q) - toEigen(q).toRotationMatrix()).norm(), 1e-14);
        EXPECT_LT((rotate(q, a) - toEigen(q) * a).norm(), 1e-13);
        EXPECT_LT((rotateInverse(q, rotate(q, a)) - a).norm(), 1e-13);
    }
}

TEST(Quaternion, ProductComposesRotations)
{
    std::mt19937 rng(2);
    for (int i = 0; i < kPoints; ++i)
    {
        const Eigen::Vector4d q = randomQuaternion(rng), p = randomQuaternion(rng);
        const Eigen::Matrix3d both = rotationMatrix(quaternionProduct(q, p));
        EXPECT_LT((both - rotationMatrix(q) * rotationMatrix(p)).norm(), 1e-14);
        const Eigen::Vector4d one = quaternionProduct(q, quaternionConjugate(q));
        EXPECT_LT((one - Eigen::Vector4d::UnitX()).norm(), 1e-14);
    }
}

TEST(Quaternion, HomogeneousMatrixScalesWithTheSquaredLength)
{
    std::mt19937 rng(3);
    const Eigen::Vector4d q = randomQuaternion(rng);
    EXPECT_LT((rotationMatrix(3 * q) - 9 * rotationMatrix(q)).norm(), 1e-13);
}

TEST(Quaternion, FromMatrixGivesBackTheQuaternionWithPositiveReal)
{
    std::mt19937 rng(4);
    for (int i = 0; i < kPoints; ++i)
    {
        const Eigen::Vector4d q = randomQuaternion(rng);
        const Eigen::Vector4d back = quaternionFromMatrix(rotationMatrix(q));
        EXPECT_GE(back[0], 0);
        EXPECT_LT((back - (q[0] < 0 ? -q : q)).norm(), 1e-13);
    }
}

TEST(Quaternion, ExpIsTheRotationAboutItsVector)
{
    std::mt19937 rng(5);
    for (int i = 0; i < kPoints; ++i)
    {
        const Eigen::Vector3d phi = uniformVector<3>(rng, 4.0);
        const Eigen::AngleAxisd expected(phi.norm(), phi.normalized());
        EXPECT_LT((rotationMatrix(quaternionExp(phi)) - expected.toRotationMatrix()).norm(), 1e-13);
    }
    EXPECT_EQ(quaternionExp(Eigen::Vector3d::Zero()), Eigen::Vector4d::UnitX());
}

TEST(Quaternion, ExpAndItsJacobianAreContinuousWhereTheSeriesTakesOver)
{
    const Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 3).normalized();
    Matrix43d J_series, J_closed;
    const Eigen::Vector4d q_series = quaternionExp(axis * 0.9999999999e-3, &J_series);
    const Eigen::Vector4d q_closed = quaternionExp(axis * 1.0000000001e-3, &J_closed);
    EXPECT_LT((q_series - q_closed).norm(), 1e-12);
    EXPECT_LT((J_series - J_closed).norm(), 1e-12);
}

TEST(Quaternion, LogInvertsExpForBothSigns)
{
    std::mt19937 rng(6);
    for (const double angle : {0.0, 1e-14, 1e-9, 1e-3, 0.5, 2.0, kPi - 1e-6})
        for (int i = 0; i < 20; ++i)
        {
            const Eigen::Vector3d phi = angle * uniformVector<3>(rng, 1.0).normalized();
            const Eigen::Vector4d q = quaternionExp(phi);
            EXPECT_LT((quaternionLog(q) - phi).norm(), 1e-14 + 1e-12 * angle);
            EXPECT_LT((quaternionLog(-q) - phi).norm(), 1e-14 + 1e-12 * angle);
        }
}

TEST(Quaternion, LogTakesTheShorterWay)
{
    const Eigen::Vector3d phi(0, 0, 1.5 * kPi);
    EXPECT_LT((quaternionLog(quaternionExp(phi)) - Eigen::Vector3d(0, 0, -0.5 * kPi)).norm(),
              1e-12);
}

TEST(Quaternion, ProductJacobiansMatchDifferences)
{
    std::mt19937 rng(7);
    for (int i = 0; i < kPoints; ++i)
    {
        const Eigen::Vector4d q = uniformVector<4>(rng, 1.5), p = uniformVector<4>(rng, 1.5);
        Eigen::Matrix4d J_q, J_p;
        (void)quaternionProduct(q, p, &J_q, &J_p);
        const auto ofQ = [&](const Eigen::Vector4d& moved) { return quaternionProduct(moved, p); };
        const auto ofP = [&](const Eigen::Vector4d& moved) { return quaternionProduct(q, moved); };
        EXPECT_TRUE(jacobianMatches(ofQ, q, J_q, 1e-9));
        EXPECT_TRUE(jacobianMatches(ofP, p, J_p, 1e-9));
    }
}

TEST(Quaternion, ExpJacobianMatchesDifferencesDownToZeroRate)
{
    std::mt19937 rng(8);
    const auto f = [](const Eigen::Vector3d& phi) { return quaternionExp(phi); };
    for (const double scale : {0.0, 1e-12, 1e-7, 1e-4, 1e-3, 0.1, 3.0})
        for (int i = 0; i < 20; ++i)
        {
            const Eigen::Vector3d phi = uniformVector<3>(rng, scale);
            Matrix43d J;
            (void)quaternionExp(phi, &J);
            EXPECT_TRUE(jacobianMatches(f, phi, J, 1e-10, 1e-3)) << phi.transpose();
        }
}

TEST(Quaternion, RotationJacobiansMatchDifferencesForAnyLength)
{
    std::mt19937 rng(9);
    for (int i = 0; i < kPoints; ++i)
    {
        const Eigen::Vector4d q = uniform(rng, 0.5, 2.0) * randomQuaternion(rng);
        const Eigen::Vector3d a = uniformVector<3>(rng, 2.0);
        Matrix34d J, J_inverse;
        (void)rotate(q, a, &J);
        (void)rotateInverse(q, a, &J_inverse);
        const auto f = [&](const Eigen::Vector4d& moved) { return rotate(moved, a); };
        const auto g = [&](const Eigen::Vector4d& moved) { return rotateInverse(moved, a); };
        EXPECT_TRUE(jacobianMatches(f, q, J, 1e-9));
        EXPECT_TRUE(jacobianMatches(g, q, J_inverse, 1e-9));
    }
}

TEST(Quaternion, NormalisationJacobianMatchesDifferencesAndForgetsTheLength)
{
    std::mt19937 rng(10);
    const auto f = [](const Eigen::Vector4d& moved) { return normalizeQuaternion(moved); };
    for (int i = 0; i < kPoints; ++i)
    {
        const Eigen::Vector4d q = uniform(rng, 0.5, 2.0) * randomQuaternion(rng);
        Eigen::Matrix4d J;
        EXPECT_NEAR(normalizeQuaternion(q, &J).norm(), 1.0, 1e-15);
        EXPECT_TRUE(jacobianMatches(f, q, J, 1e-9));
        EXPECT_LT((J * q).norm(), 1e-14);
    }
}
}  // namespace monoslam
