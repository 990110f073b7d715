// SPDX-License-Identifier: BSD-3-Clause
// How the points of the metric target enter the map.
#include <Eigen/Geometry>

#include "MapKeeper.h"
#include "monoslam_models/quaternion.h"
#include "monoslam_slam/FrameReport.h"

namespace monoslam
{
namespace
{
/** Joint covariance of the target's points [m^2], each of its own std sigma.
 *
 * The camera's first pose is exact by definition of the world; what PnP does not know of it is the
 * common error of the points:  dp = -dr0 - phi x (p - r0),  phi = R0 dtheta0. */
Eigen::MatrixXd pointCovariance(const MetricPose& target, double sigma)
{
    const Vector7d& pose = target.pose;
    const Eigen::Matrix3d R_wc = rotationMatrix(pose.tail<4>());
    Eigen::Matrix<double, Eigen::Dynamic, 6> J(
        3 * static_cast<Eigen::Index>(target.points_m.size()), 6);
    for (std::size_t i = 0; i < target.points_m.size(); ++i)
    {
        const Eigen::Vector3d d = target.points_m[i] - pose.head<3>();
        const auto row = 3 * static_cast<Eigen::Index>(i);
        J.block<3, 3>(row, 0) = -Eigen::Matrix3d::Identity();
        for (Eigen::Index k = 0; k < 3; ++k) J.block<3, 1>(row, 3 + k) = d.cross(R_wc.col(k));
    }
    Vector13d x_v = Vector13d::Zero();
    Matrix13d P_v = Matrix13d::Zero();
    x_v.head<7>() = pose;
    P_v.topLeftCorner<7, 7>() = target.P;
    Eigen::MatrixXd P_pp = J * poseCovariance(x_v, P_v) * J.transpose();
    P_pp.diagonal().array() += sigma * sigma;
    return P_pp;
}
}  // namespace

Mixture MapKeeper::addKnownPoints(Mixture mixture, const MetricPose& target,
                                  const FrameContext& frame)
{
    const Eigen::MatrixXd P_pp = pointCovariance(target, options_.metricStart.point_sigma_m);
    for (std::size_t i = 0; i < target.points_m.size(); ++i)
    {
        const LandmarkId id = nextId_++;
        const auto row = 3 * static_cast<Eigen::Index>(i);
        for (auto& weighted : mixture)
        {
            Eigen::MatrixXd P_yx = Eigen::MatrixXd::Zero(3, weighted.belief.size());
            P_yx.rightCols(row) = P_pp.block(row, 0, 3, row);
            weighted.belief = append(std::move(weighted.belief), id, LandmarkKind::Point,
                                     target.points_m[i], P_yx, P_pp.block<3, 3>(row, row));
        }
        LandmarkRecord record;
        record.born = {frame.image, target.pixels_px[i], best(mixture).pose(), {}};
        record.bornFrame = record.lastSeen = frame.index;
        record.known = target.points_m[i];
        enter(id, record, mixture);
    }
    return mixture;
}
}  // namespace monoslam
