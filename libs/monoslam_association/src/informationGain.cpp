// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/informationGain.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
/** Eigenvalue of a correlation matrix below which a direction has no variance of its own. */
constexpr double kDependent = 1e-10;

/** d(dr, dtheta) / d(r, q), dtheta = 2 vec(q* (x) q_true). */
Eigen::Matrix<double, 6, 7> poseErrorBasis(const Eigen::Vector4d& q)
{
    Eigen::Matrix4d QL;
    static_cast<void>(quaternionProduct(quaternionConjugate(q), q, nullptr, &QL));
    Eigen::Matrix<double, 6, 7> T = Eigen::Matrix<double, 6, 7>::Zero();
    T.topLeftCorner<3, 3>().setIdentity();
    T.bottomRightCorner<3, 4>() = 2.0 * QL.bottomRows<3>();
    return T;
}
}  // namespace

double informationAboutState(const Eigen::Matrix2d& S, const Eigen::Matrix2d& R)
{
    const double prior = S.determinant();
    const double noise = R.determinant();
    return prior > 0.0 && noise > 0.0 ? 0.5 * std::log2(prior / noise) : 0.0;
}

PoseInformation::PoseInformation(const Vector7d& pose, const Eigen::Matrix<double, 7, 7>& P_xx)
{
    using Matrix6d = Eigen::Matrix<double, 6, 6>;
    Eigen::Matrix<double, 6, 7> T = poseErrorBasis(pose.tail<4>());
    const Matrix6d P_ee = T * P_xx * T.transpose();
    // Metres and radians differ by orders of magnitude: judge dependence by correlation.
    for (Eigen::Index i = 0; i < 6; ++i)
        T.row(i) *= P_ee(i, i) > 0.0 ? 1.0 / std::sqrt(P_ee(i, i)) : 0.0;
    const Matrix6d correlation = T * P_xx * T.transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(0.5 *
                                                         (correlation + correlation.transpose()));
    for (Eigen::Index i = 0; i < 6; ++i)
    {
        const double eigenvalue = solver.eigenvalues()(i);
        const double scale = eigenvalue > kDependent ? 1.0 / std::sqrt(eigenvalue) : 0.0;
        whitening_.row(i) = scale * solver.eigenvectors().col(i).transpose() * T;
    }
}

double PoseInformation::operator()(const Eigen::Matrix<double, 7, 2>& C,
                                   const Eigen::Matrix2d& S) const
{
    const double prior = S.determinant();
    if (!(prior > 0.0)) return 0.0;
    const Eigen::Matrix<double, 6, 2> G = whitening_ * C;
    const double known = (S - G.transpose() * G).determinant();
    return known > 0.0 ? 0.5 * std::log2(prior / known) : std::numeric_limits<double>::infinity();
}
}  // namespace monoslam
