// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/** (dr in the world, dtheta in the camera frame) from pose a to pose b, each (r_wc, q_wc). */
inline Vector6d poseDifference(const Eigen::Matrix<double, 7, 1>& a,
                               const Eigen::Matrix<double, 7, 1>& b)
{
    Eigen::Vector4d dq = quaternionProduct(quaternionConjugate(a.tail<4>()), b.tail<4>());
    if (dq(0) < 0) dq = -dq;
    Vector6d d;
    d << b.head<3>() - a.head<3>(), quaternionLog(dq);
    return d;
}

/** Covariance of that difference from the 7 x 7 one of a pose. */
inline Matrix6d covariance6(const Eigen::Matrix<double, 7, 1>& pose,
                            const Eigen::Matrix<double, 7, 7>& P)
{
    Eigen::Matrix4d QL;
    (void)quaternionProduct(pose.tail<4>(), pose.tail<4>(), nullptr, &QL);
    Eigen::Matrix<double, 6, 7> J = Eigen::Matrix<double, 6, 7>::Zero();
    J.topLeftCorner<3, 3>().setIdentity();
    J.bottomRightCorner<3, 4>() = 2.0 * QL.rightCols<3>().transpose();
    return J * P * J.transpose();
}

/** Squared Mahalanobis distance of a pose from the truth, 6 degrees of freedom. */
inline double mahalanobis2(const Eigen::Matrix<double, 7, 1>& truth,
                           const Eigen::Matrix<double, 7, 1>& pose,
                           const Eigen::Matrix<double, 7, 7>& P)
{
    const Vector6d d = poseDifference(truth, pose);
    return d.dot(covariance6(pose, P).ldlt().solve(d));
}
}  // namespace monoslam
