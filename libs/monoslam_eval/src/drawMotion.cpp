// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/drawMotion.h"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
using namespace camera_state;

template <int N>
Eigen::Matrix<double, N, 1> normalVector(std::mt19937& rng)
{
    std::normal_distribution<double> normal;
    Eigen::Matrix<double, N, 1> numbers;
    for (double& number : numbers) number = normal(rng);
    return numbers;
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
}  // namespace monoslam
