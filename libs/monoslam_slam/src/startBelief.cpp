// SPDX-License-Identifier: BSD-3-Clause
#include "startBelief.h"

#include <Eigen/Geometry>

#include "monoslam_models/quaternion.h"
#include "monoslam_slam/FrameReport.h"

namespace monoslam
{
namespace
{
constexpr double kExact = 1e-12;  ///< variance of what defines the world

Matrix13d startCovariance(double sigma_v, double sigma_omega_radps)
{
    Matrix13d P_v = kExact * Matrix13d::Identity();
    P_v.diagonal().segment<3>(camera_state::kVelocity).setConstant(sigma_v * sigma_v);
    P_v.diagonal()
        .segment<3>(camera_state::kAngularVelocity)
        .setConstant(sigma_omega_radps * sigma_omega_radps);
    return P_v;
}
}  // namespace

StartBelief startBelief(const MetricPose* target, const InitializationOptions& options)
{
    StartBelief start;
    start.rho0 = options.rho0;
    start.sigma_rho = options.sigma_rho;
    Vector13d x_v = Vector13d::Zero();
    x_v(camera_state::kOrientation) = 1.0;
    if (target)
    {
        x_v.head<7>() = target->pose;
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (const auto& p : target->points_m)
            middle += p / static_cast<double>(target->points_m.size());
        start.rho0 = 1.0 / (middle - target->pose.head<3>()).norm();
        start.sigma_rho = options.relative_sigma_rho * start.rho0;
    }
    start.belief =
        Belief::ofCamera(x_v, startCovariance(options.sigma_v, options.sigma_omega_radps));
    return start;
}

StartBelief restartBelief(const Belief& old, double rho0, const InitializationOptions& options)
{
    StartBelief start;
    start.rho0 = rho0;
    start.sigma_rho = options.relative_sigma_rho * rho0;
    Vector13d x_v = old.camera();
    x_v.tail<6>().setZero();
    const double sigma_v = options.sigma_v / (options.rho0 > 0.0 ? rho0 / options.rho0 : 1.0);
    start.belief = Belief::ofCamera(x_v, startCovariance(sigma_v, options.sigma_omega_radps));
    return start;
}

Eigen::Matrix<double, 7, 7> worldCovariance(const WorldOrigin& origin, const Vector7d& pose)
{
    Vector13d x_v = Vector13d::Zero();
    Matrix13d P_origin = Matrix13d::Zero();
    x_v.head<7>() = origin.pose;
    P_origin.topLeftCorner<7, 7>() = origin.P;
    const Eigen::Matrix<double, 6, 6> P_first = poseCovariance(x_v, P_origin);
    const Eigen::Matrix3d R_w0 = rotationMatrix(origin.pose.tail<4>());
    const Eigen::Matrix3d R_wc = rotationMatrix(pose.tail<4>());
    const Eigen::Vector3d d = pose.head<3>() - origin.pose.head<3>();
    Eigen::Matrix4d QL;
    (void)quaternionProduct(pose.tail<4>(), Eigen::Vector4d::UnitX(), nullptr, &QL);
    Eigen::Matrix<double, 7, 6> J = Eigen::Matrix<double, 7, 6>::Zero();
    J.topLeftCorner<3, 3>().setIdentity();
    for (Eigen::Index k = 0; k < 3; ++k)
        J.block<3, 1>(camera_state::kPosition, 3 + k) = R_w0.col(k).cross(d);
    J.bottomRightCorner<4, 3>() = 0.5 * QL.rightCols<3>() * R_wc.transpose() * R_w0;
    return J * P_first * J.transpose();
}
}  // namespace monoslam
