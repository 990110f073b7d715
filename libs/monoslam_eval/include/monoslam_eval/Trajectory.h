// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "monoslam_eval/export.h"

namespace monoslam
{
/** Camera pose at a time: p_w = R(q_wc) p_c + r_wc. */
struct StampedPose
{
    double t_s = 0.0;
    Eigen::Vector3d r_wc = Eigen::Vector3d::Zero();      ///< [m]
    Eigen::Vector4d q_wc = Eigen::Vector4d(1, 0, 0, 0);  ///< unit, (w, x, y, z)
};
using Trajectory = std::vector<StampedPose>;

/** Reads lines "t x y z qx qy qz qw"; '#' starts a comment line.
 *  \throw std::invalid_argument naming file and line: unreadable, not eight finite numbers, a
 *  quaternion whose length is not 1 within 1 %, or time that does not increase */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Trajectory readTum(const std::string& fileName);

/** An estimated pose and the true one at its time. */
struct PosePair
{
    std::size_t index = 0;  ///< of the estimate in its trajectory
    StampedPose estimate;
    StampedPose truth;  ///< its t_s is that of the estimate
};

struct TimeMatchingOptions
{
    double tolerance_s = 0.02;  ///< to the nearest true pose
    bool interpolate = true;    ///< between two true poses at most twice the tolerance apart
};

/** Truth at the time of each estimate; estimates without one are left out.
 *
 * Positions are interpolated linearly, orientations on the great circle. Without interpolation
 * the nearest pose is taken, as evo does when the truth has at least as many poses. */
[[nodiscard]] MONOSLAM_EVAL_EXPORT std::vector<PosePair> matchByTime(
    const Trajectory& estimate, const Trajectory& truth, const TimeMatchingOptions& options = {});

/** Sum of the distances between successive positions [m]. */
[[nodiscard]] MONOSLAM_EVAL_EXPORT double pathLength(const Trajectory& trajectory);
}  // namespace monoslam
