// SPDX-License-Identifier: BSD-3-Clause
#include "beliefFromWindow.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "monoslam_filter/editBelief.h"
#include "monoslam_filter/ekf.h"
#include "monoslam_models/InverseDepth.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
using Matrix13x18d = Eigen::Matrix<double, 13, 18>;

constexpr Eigen::Index kPoses = 18;
constexpr double kFarRho = 1e-4;

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v)
{
    Eigen::Matrix3d V;
    V << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return V;
}

/** Covariance with the first view's errors taken out: the world is where that camera stood.
 *  Errors with the first view held fixed: dp - dr0 - phi x (p - r0), phi = R0 dtheta0. */
Eigen::MatrixXd fromFirstView(const SmoothedWindow& smoothed)
{
    const Eigen::Index n = smoothed.P.rows();
    Eigen::MatrixXd A = Eigen::MatrixXd::Identity(n, n);
    const Eigen::Vector3d r0 = smoothed.poses.front().head<3>();
    const Eigen::Matrix3d R0 = rotationMatrix(smoothed.poses.front().tail<4>());
    const auto turned = [&](const Eigen::Vector3d& p)
    { return Eigen::Matrix3d(crossMatrix(p - r0) * R0); };
    const std::size_t last = smoothed.poses.size() - 1;
    for (Eigen::Index i = 1; i <= 2; ++i)
    {
        const Vector7d& pose = smoothed.poses[last - 2 + static_cast<std::size_t>(i)];
        A.block<3, 3>(6 * i, 0) = -Eigen::Matrix3d::Identity();
        A.block<3, 3>(6 * i, 3) = turned(pose.head<3>());
        A.block<3, 3>(6 * i + 3, 3) = -rotationMatrix(pose.tail<4>()).transpose() * R0;
    }
    for (std::size_t l = 0; l < smoothed.landmarks.size(); ++l)
    {
        const WindowLandmark& landmark = smoothed.landmarks[l];
        const Eigen::Index at = kPoses + 3 * static_cast<Eigen::Index>(l);
        Eigen::Matrix3d J_y_p = Eigen::Matrix3d::Identity();
        Eigen::Vector3d p_w = landmark.y.head<3>();
        if (landmark.kind == LandmarkKind::InverseDepth)
        {
            Vector6d y = landmark.y;
            y(inverse_depth::kRho) = std::max(y(inverse_depth::kRho), kFarRho);
            Matrix36d J_p_y;
            p_w = toPoint(y, &J_p_y);
            J_y_p = J_p_y.rightCols<3>().inverse();
        }
        A.block<3, 3>(at, 0) = -J_y_p;
        A.block<3, 3>(at, 3) = J_y_p * turned(p_w);
    }
    A.topLeftCorner<6, 6>().setZero();
    return A * smoothed.P * A.transpose();
}

/** Camera state at the last view, its velocities the mean ones of the last step. */
Vector13d cameraState(const Vector7d& before, const Vector7d& last, double dt_s)
{
    Vector13d x_v;
    x_v.head<7>() = last;
    x_v.segment<3>(camera_state::kVelocity) = (last.head<3>() - before.head<3>()) / dt_s;
    x_v.segment<3>(camera_state::kAngularVelocity) =
        quaternionLog(quaternionProduct(quaternionConjugate(before.tail<4>()), last.tail<4>())) /
        dt_s;
    return x_v;
}

/** Of cameraState() with respect to the (dr, dtheta) of the first, last but one and last view. */
Matrix13x18d cameraJacobian(const Vector7d& before, const Vector7d& last, double dt_s)
{
    Eigen::Matrix4d QL;
    (void)quaternionProduct(last.tail<4>(), Eigen::Vector4d::UnitX(), nullptr, &QL);
    const Eigen::Matrix3d R_last_before =
        rotationMatrix(last.tail<4>()).transpose() * rotationMatrix(before.tail<4>());
    Matrix13x18d J = Matrix13x18d::Zero();
    J.block<3, 3>(camera_state::kPosition, 12).setIdentity();
    J.block<4, 3>(camera_state::kOrientation, 15) = 0.5 * QL.rightCols<3>();
    J.block<3, 3>(camera_state::kVelocity, 6) = -Eigen::Matrix3d::Identity() / dt_s;
    J.block<3, 3>(camera_state::kVelocity, 12) = Eigen::Matrix3d::Identity() / dt_s;
    J.block<3, 3>(camera_state::kAngularVelocity, 9) = -R_last_before / dt_s;
    J.block<3, 3>(camera_state::kAngularVelocity, 15) = Eigen::Matrix3d::Identity() / dt_s;
    return J;
}

/** Appends the landmarks kept, with their covariances with the camera and with each other. */
Belief appendLandmarks(Belief belief, const WindowEstimate& estimate, const Eigen::MatrixXd& P,
                       const Matrix13x18d& J)
{
    std::vector<Eigen::Index> columns;  // of the free numbers of what is already in the state
    for (std::size_t l = 0; l < estimate.keep.size(); ++l)
    {
        if (!estimate.keep[l]) continue;
        const WindowLandmark& landmark = estimate.smoothed.landmarks[l];
        const Eigen::Index at = kPoses + 3 * static_cast<Eigen::Index>(l);
        const Eigen::Index size = landmarkSize(landmark.kind);
        const Eigen::Index skip = size - 3;  // the fixed anchor of an inverse depth
        const Eigen::Index n = belief.size();
        Eigen::MatrixXd P_yx = Eigen::MatrixXd::Zero(size, n);
        Eigen::MatrixXd P_yy = Eigen::MatrixXd::Zero(size, size);
        P_yy.bottomRightCorner<3, 3>() = P.block<3, 3>(at, at);
        P_yx.block(skip, 0, 3, 13) = P.block(at, 0, 3, kPoses) * J.transpose();
        Eigen::Index offset = 13;
        for (std::size_t i = 0; i < columns.size(); ++i)
        {
            const Eigen::Index otherSize = belief.landmarks[i].size();
            P_yx.block<3, 3>(skip, offset + otherSize - 3) = P.block<3, 3>(at, columns[i]);
            offset += otherSize;
        }
        columns.push_back(at);
        belief = append(std::move(belief), estimate.ids[l], landmark.kind, landmark.y, P_yx, P_yy);
    }
    return belief;
}
}  // namespace

Belief beliefFromWindow(const WindowEstimate& estimate, const ConstantVelocityOptions& motion)
{
    const SmoothedWindow& smoothed = estimate.smoothed;
    Eigen::MatrixXd P = estimate.metric ? fromFirstView(smoothed) : smoothed.P;
    // The views left out saw the landmarks too: what the filter had learnt from them is not lost.
    const Eigen::Index landmarks = P.rows() - kPoses;
    P.bottomRows(landmarks) *= std::sqrt(estimate.share);
    P.rightCols(landmarks) *= std::sqrt(estimate.share);
    const Vector7d& before = smoothed.poses[smoothed.poses.size() - 2];
    const Vector7d& last = smoothed.poses.back();
    const Vector13d x_v = cameraState(before, last, estimate.dt_s);
    const Matrix13x18d J = cameraJacobian(before, last, estimate.dt_s);

    // The velocities are the mean ones of the last step: the step's own noise is added.
    const Matrix13d Q = predictConstantVelocity(x_v, estimate.dt_s, motion).Q;
    Matrix13d P_v = J * P.topLeftCorner<kPoses, kPoses>() * J.transpose();
    P_v.bottomRightCorner<6, 6>() += Q.bottomRightCorner<6, 6>();
    Belief belief = Belief::ofCamera(x_v, P_v);

    belief = appendLandmarks(std::move(belief), estimate, P, J);
    normalizeQuaternions(belief);
    return belief;
}
}  // namespace monoslam
