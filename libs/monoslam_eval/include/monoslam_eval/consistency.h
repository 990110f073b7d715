// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "monoslam_eval/metrics.h"
#include "monoslam_models/InverseDepth.h"

namespace monoslam
{
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/** Pose error (dr in the world [m], dtheta in the camera frame [rad]), dtheta = 2 vec(q_gt* q). */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Vector6d poseError(const StampedPose& estimate,
                                                      const StampedPose& truth);

/** e' P^-1 e; nothing if P is not positive definite (a pose that is known exactly). */
[[nodiscard]] MONOSLAM_EVAL_EXPORT std::optional<double> nees(const Vector6d& e, const Matrix6d& P);

/** Covariance of that error from a belief's camera: T P T' with T_q = 2 vec(q* .) (algorithms
 *  10.4); regular although P has a null direction along q. */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Matrix6d poseErrorCovariance(const Vector7d& pose,
                                                                const Eigen::MatrixXd& P);

struct Interval
{
    double low = 0.0;
    double high = 0.0;
};

/** Two-sided bounds of the mean of `runs` independent chi-square numbers with `dof` each. */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Interval chi2MeanBounds(int dof, int runs, double probability);

struct StampedCovariance
{
    double t_s = 0.0;
    Matrix6d P;
};

/** Reads covariance.csv: t_s and the 21 upper entries of the 6 x 6 covariance, row by row.
 *  \throw std::invalid_argument naming file and line */
[[nodiscard]] MONOSLAM_EVAL_EXPORT std::vector<StampedCovariance> readCovariances(
    const std::string& fileName);

/** NEES (6 numbers) of every pair under an alignment; nothing for one without a covariance or whose
 *  pose is known exactly. */
[[nodiscard]] MONOSLAM_EVAL_EXPORT std::vector<std::optional<double>> trajectoryNees(
    const std::vector<PosePair>& pairs, const std::vector<StampedCovariance>& covariances,
    const Similarity& alignment);
}  // namespace monoslam
