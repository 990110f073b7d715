// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "monoslam_models/export.h"

/** Unit quaternions q = (w, x, y, z), Hamilton product; R(q_wc) maps camera to world.
 *
 * Every Jacobian is that of the homogeneous form, so it also holds for a q that is not of unit
 * length, which is what an EKF update leaves behind. Output Jacobians are optional and last. */
namespace monoslam
{
using Matrix34d = Eigen::Matrix<double, 3, 4>;
using Matrix43d = Eigen::Matrix<double, 4, 3>;

/** R(q), homogeneous: R(q) = |q|^2 times a rotation. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT Eigen::Matrix3d rotationMatrix(const Eigen::Vector4d& q);

/** The unit quaternion with w >= 0 of a rotation matrix. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT Eigen::Vector4d quaternionFromMatrix(
    const Eigen::Matrix3d& R_wc);

/** q (x) p, with QL(q) = d/dp and QR(p) = d/dq. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT Eigen::Vector4d quaternionProduct(
    const Eigen::Vector4d& q, const Eigen::Vector4d& p, Eigen::Matrix4d* J_qp_q = nullptr,
    Eigen::Matrix4d* J_qp_p = nullptr);

[[nodiscard]] MONOSLAM_MODELS_EXPORT Eigen::Vector4d quaternionConjugate(const Eigen::Vector4d& q);

/** exp: the quaternion of a rotation vector phi [rad]; regular at phi = 0. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT Eigen::Vector4d quaternionExp(const Eigen::Vector3d& phi,
                                                                   Matrix43d* J_q_phi = nullptr);

/** log: the rotation vector [rad], |phi| <= pi, of a unit quaternion (inverse of exp). */
[[nodiscard]] MONOSLAM_MODELS_EXPORT Eigen::Vector3d quaternionLog(const Eigen::Vector4d& q);

/** R(q) a. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT Eigen::Vector3d rotate(const Eigen::Vector4d& q,
                                                            const Eigen::Vector3d& a,
                                                            Matrix34d* J_Ra_q = nullptr);

/** R(q)^T a. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT Eigen::Vector3d rotateInverse(const Eigen::Vector4d& q,
                                                                   const Eigen::Vector3d& a,
                                                                   Matrix34d* J_RTa_q = nullptr);

/** q / |q|, J = (I - q q'/|q|^2) / |q| at the q before normalisation. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT Eigen::Vector4d normalizeQuaternion(
    const Eigen::Vector4d& q, Eigen::Matrix4d* J_n_q = nullptr);
}  // namespace monoslam
