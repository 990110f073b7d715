// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace monoslam
{
/** Radius of the 95 % circle about a line of sight by which one prediction moves what is seen at the
 *  inverse depth rho [rad]: sqrt(chi2(2) sigma^2) with sigma^2 the mean over the axes of
 *  rho^2 (P_r' - P_r) + (P_theta' - P_theta), P before and P' after.
 *  \param before, after  covariances of (dr, dtheta), as poseCovariance() has them */
[[nodiscard]] double lineOfSightGrowth_rad(const Eigen::Matrix<double, 6, 6>& before,
                                           const Eigen::Matrix<double, 6, 6>& after, double rho);
}  // namespace monoslam
