// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_models/projectOnTangent.h"

#include "monoslam_models/InverseDepth.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
ViewPose::ViewPose(const Vector7d& pose)
    : R_cw(rotationMatrix(pose.tail<4>()).transpose()), r_wc(pose.head<3>())
{
}

LandmarkRay::LandmarkRay(LandmarkKind form, const Eigen::Ref<const Eigen::VectorXd>& y)
    : kind(form), from_w(y.head<3>()), m_w(Eigen::Vector3d::Zero()), J_m_angles(Matrix32d::Zero())
{
    using namespace inverse_depth;
    if (form == LandmarkKind::Point) return;
    rho = y[kRho];
    m_w = rayDirection(y[kTheta], y[kPhi], &J_m_angles);
}

std::optional<TangentProjection> projectOnTangent(const Camera& camera, const ViewPose& view,
                                                  const LandmarkRay& landmark)
{
    const Eigen::Vector3d fromCamera = landmark.from_w - view.r_wc;
    const Eigen::Vector3d d_c = view.R_cw * (landmark.rho * fromCamera + landmark.m_w);
    Matrix23d A;
    const auto h = camera.project(d_c, &A);
    if (!h) return std::nullopt;
    TangentProjection projected;
    projected.h = *h;
    const Matrix23d A_w = A * view.R_cw;
    projected.J_h_pose.leftCols<3>() = -landmark.rho * A_w;
    for (Eigen::Index row = 0; row < 2; ++row)  // A [d_c]x
    {
        projected.J_h_pose(row, 3) = A(row, 1) * d_c.z() - A(row, 2) * d_c.y();
        projected.J_h_pose(row, 4) = A(row, 2) * d_c.x() - A(row, 0) * d_c.z();
        projected.J_h_pose(row, 5) = A(row, 0) * d_c.y() - A(row, 1) * d_c.x();
    }
    if (landmark.kind == LandmarkKind::Point)
        projected.J_h_landmark = A_w;
    else
        projected.J_h_landmark << A_w * landmark.J_m_angles, A_w * fromCamera;
    return projected;
}

std::optional<Eigen::Vector2d> projectRay(const Camera& camera, const ViewPose& view,
                                          const LandmarkRay& landmark)
{
    return camera.project(view.R_cw *
                          (landmark.rho * (landmark.from_w - view.r_wc) + landmark.m_w));
}
}  // namespace monoslam
