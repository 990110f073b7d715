// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "monoslam_eval/Trajectory.h"
#include "monoslam_eval/export.h"

namespace monoslam
{
/** Of a set of errors; NaN where there are none. */
struct Statistics
{
    double rmse = std::numeric_limits<double>::quiet_NaN();
    double mean = std::numeric_limits<double>::quiet_NaN();
    double median = std::numeric_limits<double>::quiet_NaN();
    double max = std::numeric_limits<double>::quiet_NaN();
    long count = 0;
};
[[nodiscard]] MONOSLAM_EVAL_EXPORT Statistics statistics(std::vector<double> errors);

enum class Alignment
{
    None,
    SE3,   ///< rotation and translation: the scale is kept
    Sim3,  ///< and scale
};

/** y = s R x + t. */
struct Similarity
{
    double s = 1.0;
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    Eigen::Vector3d t = Eigen::Vector3d::Zero();
};
[[nodiscard]] MONOSLAM_EVAL_EXPORT StampedPose transform(const Similarity& similarity,
                                                         StampedPose pose);

/** Least-squares similarity that takes the estimated positions to the true ones.
 *
 *      C = 1/n sum (y - mu_y)(x - mu_x)' = U D V',  W = diag(1, 1, det U det V),
 *      R = U W V',  s = tr(D W) / var_x,  t = mu_y - s R mu_x
 *
 * \return the identity for None, or with fewer than three pairs or without motion
 * \see Umeyama, "Least-squares estimation of transformation parameters between two point
 * patterns", PAMI 1991 */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Similarity align(const std::vector<PosePair>& pairs,
                                                    Alignment alignment);

/** Takes the first estimated pose to the first true one, with the scale of the fit: the frame in
 *  which the covariance of a start without target is meant (Sim3), or of a metric one whose world is
 *  not the truth's (SE3). */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Similarity alignFirstPose(const std::vector<PosePair>& pairs,
                                                             Alignment alignment = Alignment::Sim3);

/** Errors of a trajectory under one alignment. */
struct TrajectoryErrors
{
    Similarity alignment;
    Statistics position_m;      ///< ATE: |p_gt - (s R p + t)|
    Statistics rotation_rad;    ///< angle between the aligned and the true orientation
    Statistics stepPosition_m;  ///< RPE over one frame
    Statistics stepRotation_rad;
    Statistics secondPosition_m;  ///< RPE over 1 s
    Statistics secondRotation_rad;
};
[[nodiscard]] MONOSLAM_EVAL_EXPORT TrajectoryErrors
trajectoryErrors(const std::vector<PosePair>& pairs, Alignment alignment);

/** Rotation error [rad] after the one rotation that fits the orientations best (a rotation from
 *  positions alone is undetermined about a straight path). */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Statistics rotationErrors(const std::vector<PosePair>& pairs);

/** Scale of the Sim3 fit in the first and the last third of the pairs. */
struct ScaleDrift
{
    double first = std::numeric_limits<double>::quiet_NaN();
    double last = std::numeric_limits<double>::quiet_NaN();
    /** first / last - 1: by how much the estimate grew against the truth. */
    double drift = std::numeric_limits<double>::quiet_NaN();
    /** Both fits leave less than a fifth of their third's motion; else the drift means little. */
    bool reliable = false;
};
[[nodiscard]] MONOSLAM_EVAL_EXPORT ScaleDrift scaleDrift(const std::vector<PosePair>& pairs);

/** ATE rmse of a camera that never moves: rms distance of the true positions to their mean [m]. */
[[nodiscard]] MONOSLAM_EVAL_EXPORT double standingStillError(const std::vector<PosePair>& pairs);

/** A path out and back along a straight line, judged without ground truth. */
struct OutAndBack
{
    double length = 0.0;      ///< of the whole path
    double gap = 0.0;         ///< distance from the end to the start
    double offLine = 0.0;     ///< largest distance from the line that fits all positions best
    double outLength = 0.0;   ///< path up to the turning point
    double backLength = 0.0;  ///< path from there on
    double outReach = 0.0;    ///< start to turning point, projected on the line
    double backReach = 0.0;   ///< turning point to end, projected on the line
};
[[nodiscard]] MONOSLAM_EVAL_EXPORT OutAndBack outAndBack(const Trajectory& trajectory);
}  // namespace monoslam
