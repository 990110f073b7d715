// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <cmath>

#include "monoslam_eval/SyntheticWorld.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
using namespace camera_state;

constexpr double kDifference_s = 1e-4;

template <int N>
Eigen::Matrix<double, N, 1> normalVector(std::mt19937& rng)
{
    std::normal_distribution<double> normal;
    Eigen::Matrix<double, N, 1> numbers;
    for (double& number : numbers) number = normal(rng);
    return numbers;
}

Vector7d smoothPose(double t_s, double amplitude)
{
    const auto wave = [t_s](double hz, double phase)
    { return std::sin(2.0 * 3.14159265358979323846 * hz * t_s + phase) - std::sin(phase); };
    Vector7d pose;
    pose.head<3>() << wave(0.23, 0.0) + 0.3 * wave(0.51, 1.0), 0.5 * wave(0.31, 0.5),
        0.4 * wave(0.17, 0.2) + 0.1 * wave(0.71, 0.0);
    pose.head<3>() *= amplitude;
    const Eigen::Vector3d phi(0.12 * wave(0.29, 0.3), 0.2 * wave(0.19, 0.1), 0.1 * wave(0.37, 0.7));
    pose.tail<4>() = quaternionExp(phi);
    return pose;
}
}  // namespace

Vector13d drawMotion(const Vector13d& x_v, double dt_s, const ConstantVelocityOptions& options,
                     std::mt19937& rng)
{
    const Matrix13d Q = predictConstantVelocity(x_v, dt_s, options).Q;
    const double sigma_V = std::sqrt(Q(kVelocity, kVelocity));
    const double sigma_Omega = std::sqrt(Q(kAngularVelocity, kAngularVelocity));
    Vector13d pushed = x_v;
    pushed.segment<3>(kVelocity) += sigma_V * normalVector<3>(rng);
    pushed.segment<3>(kAngularVelocity) += sigma_Omega * normalVector<3>(rng);
    Vector13d moved = predictConstantVelocity(pushed, dt_s, options).x_v;
    moved.segment<4>(kOrientation).normalize();
    return moved;
}

Vector13d drawCamera(const Vector13d& x_v, const Matrix13d& P_v, std::mt19937& rng)
{
    const Eigen::SelfAdjointEigenSolver<Matrix13d> eigen(P_v);
    const Vector13d e =
        eigen.eigenvectors() *
        eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().cwiseProduct(normalVector<kSize>(rng));
    Vector13d drawn = x_v + e;
    const Eigen::Vector4d q = x_v.segment<4>(kOrientation);
    const Eigen::Vector4d dq =
        quaternionProduct(quaternionConjugate(q), e.segment<4>(kOrientation));
    drawn.segment<4>(kOrientation) = quaternionProduct(q, quaternionExp(2.0 * dq.tail<3>()));
    return drawn;
}

Vector13d smoothPath(double t_s, double amplitude)
{
    const Vector7d before = smoothPose(t_s - kDifference_s, amplitude);
    const Vector7d after = smoothPose(t_s + kDifference_s, amplitude);
    Vector13d x_v;
    x_v.head<kPoseSize>() = smoothPose(t_s, amplitude);
    x_v.segment<3>(kVelocity) = (after - before).head<3>() / (2.0 * kDifference_s);
    x_v.segment<3>(kAngularVelocity) =
        quaternionLog(quaternionProduct(quaternionConjugate(before.tail<4>()), after.tail<4>())) /
        (2.0 * kDifference_s);
    return x_v;
}
}  // namespace monoslam
