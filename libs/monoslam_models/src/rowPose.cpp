// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_models/rowPose.h"

#include "monoslam_models/quaternion.h"

namespace monoslam
{
using namespace camera_state;

RowPose poseAfter(const Vector13d& x_v, double s)
{
    const Eigen::Vector3d v = x_v.segment<3>(kVelocity);
    const Eigen::Vector3d omega = x_v.segment<3>(kAngularVelocity);
    Matrix43d J_dq_phi;
    Eigen::Matrix4d J_qs_q, J_qs_dq;
    const Eigen::Vector4d dq = quaternionExp(omega * s, &J_dq_phi);
    const Eigen::Vector4d q_s =
        quaternionProduct(x_v.segment<4>(kOrientation), dq, &J_qs_q, &J_qs_dq);
    const Matrix43d J_qs_phi = J_qs_dq * J_dq_phi;

    RowPose row;
    row.pose << x_v.head<3>() + v * s, q_s;
    row.J_pose_s << v, J_qs_phi * omega;
    row.J_pose_xv.setZero();
    row.J_pose_xv.block<3, 3>(kPosition, kPosition).setIdentity();
    row.J_pose_xv.block<4, 4>(kOrientation, kOrientation) = J_qs_q;
    row.J_pose_xv.block<3, 3>(kPosition, kVelocity).diagonal().setConstant(s);
    row.J_pose_xv.block<4, 3>(kOrientation, kAngularVelocity) = s * J_qs_phi;
    return row;
}

double rowTime_s(const Camera& camera, double v_px)
{
    const CameraParameters& p = camera.parameters();
    return (v_px / p.height_px - 0.5) * p.readout_s;
}

std::optional<Eigen::Vector2d> globalPixel(const Camera& camera, const Vector13d& x_v,
                                           const Eigen::Vector2d& uv_px, double rho)
{
    if (camera.parameters().readout_s == 0.0) return uv_px;
    const auto ray = camera.unproject(uv_px);
    if (!ray) return std::nullopt;
    const Vector7d row = poseAfter(x_v, rowTime_s(camera, uv_px.y())).pose;
    // Scaled by rho, so that it stays finite for far points.
    const Eigen::Vector3d d_w =
        rotate(row.tail<4>(), ray->normalized()) + rho * (row.head<3>() - x_v.head<3>());
    return camera.project(rotateInverse(x_v.segment<4>(kOrientation), d_w));
}
}  // namespace monoslam
