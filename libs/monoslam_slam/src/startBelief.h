// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "monoslam_filter/Belief.h"
#include "monoslam_slam/InitializationOptions.h"
#include "monoslam_slam/MetricStart.h"

namespace monoslam
{
/** A camera without landmarks, and the inverse depth around which its first ones shall lie. */
struct StartBelief
{
    Belief belief;
    double rho0 = 1.0;
    double sigma_rho = 0.5;
};

/** The first belief: at the target's pose, else at the origin of a world without scale. The pose is
 *  exact, because it defines the world; the velocities are zero with their prior's covariance. */
[[nodiscard]] StartBelief startBelief(const MetricPose* target,
                                      const InitializationOptions& options);

/** A belief that starts anew at the pose of an old one, of whose map \p rho0 is the median. */
[[nodiscard]] StartBelief restartBelief(const Belief& old, double rho0,
                                        const InitializationOptions& options);

/** A pose that a map holds fixed, and what is not known of it in the world: the first one in that of a
 *  metric target, or the one at which a map was begun anew after a loss. */
struct WorldOrigin
{
    Vector7d pose;                  ///< (r_wc, q_wc)
    Eigen::Matrix<double, 7, 7> P;  ///< of it
};

/** What the uncertainty of the map's origin in the world adds to that of a later pose:
 *  dr = dr0 + phi x (r - r0), dtheta = R' phi, phi = R0 dtheta0. The filter holds the first pose fixed,
 *  because a common error of the whole map is what an EKF linearises worst. */
[[nodiscard]] Eigen::Matrix<double, 7, 7> worldCovariance(const WorldOrigin& origin,
                                                          const Vector7d& pose);
}  // namespace monoslam
