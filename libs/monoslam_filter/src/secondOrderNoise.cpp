// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/secondOrderNoise.h"

#include "monoslam_models/InverseDepth.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
using namespace inverse_depth;

Eigen::Matrix2d secondOrderNoise(const Belief& belief, const Camera& camera,
                                 const PredictedLandmark& landmark)
{
    if (landmark.size != kSize) return Eigen::Matrix2d::Zero();
    const Vector6d y = belief.x.segment<kSize>(landmark.offset);
    const Vector7d pose = belief.pose();
    const Eigen::Matrix3d R_wc = rotationMatrix(pose.tail<4>());
    const Eigen::Vector3d h_w =
        y[kRho] * (y.head<3>() - pose.head<3>()) + rayDirection(y[kTheta], y[kPhi]);
    Matrix23d J_uv_hc;
    if (!camera.project(R_wc.transpose() * h_w, &J_uv_hc)) return Eigen::Matrix2d::Zero();

    const auto& P = belief.P;
    const Eigen::Index y0 = landmark.offset + kAnchor;
    const Eigen::Index rho = landmark.offset + kRho;
    const Eigen::Matrix3d P_y0_r = P.block<3, 3>(y0, 0);
    const Eigen::Matrix3d P_dd =
        P.block<3, 3>(y0, y0) - P_y0_r - P_y0_r.transpose() + P.block<3, 3>(0, 0);
    const Eigen::Vector3d P_d_rho = P.block<3, 1>(y0, rho) - P.block<3, 1>(0, rho);
    const Matrix23d A = J_uv_hc * R_wc.transpose();
    return A * (P(rho, rho) * P_dd + P_d_rho * P_d_rho.transpose()) * A.transpose();
}
}  // namespace monoslam
