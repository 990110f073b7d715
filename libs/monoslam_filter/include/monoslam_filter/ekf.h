// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "monoslam_filter/Belief.h"
#include "monoslam_filter/export.h"
#include "monoslam_filter/predictMeasurements.h"

namespace monoslam
{
/** A pixel taken as the measurement of one row of a Prediction. */
struct PixelMeasurement
{
    Eigen::Index row = 0;  ///< in Prediction::rows
    Eigen::Vector2d z;     ///< [px]
    Eigen::Matrix2d R;     ///< [px^2]
};

/** EKF prediction by the constant-velocity model; the quaternion is normalised.
 *
 *      P_vv+ = F P_vv F' + Q,   P_vm+ = F P_vm                                        O(13^2 N)
 *
 * \param dt_s  >= 0 [s]; \throw std::invalid_argument if negative or not finite */
[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief ekfPredict(Belief belief,
                                                       const ConstantVelocityOptions& motion,
                                                       double dt_s);

/** EKF correction by one stacked set of pixels, with the prediction's P H' and H P H'.
 *
 *      S = H P H' + R = L L',   W = P H' L^-T,   x+ = x + W L^-1 nu,   P+ = P - W W'
 *
 * Equals x + K nu and P - K S K' without an inverse. Quaternions are normalised. If S is not
 * positive definite R is inflated by a tenth once and \p faults is counted up.
 * \throw std::runtime_error if S stays indefinite */
[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief ekfUpdate(Belief prior, const Prediction& prediction,
                                                      const std::vector<PixelMeasurement>& pixels,
                                                      int* faults = nullptr);

/** The same in two steps: an iterated update asks for many means and one covariance. */
struct EkfCorrection
{
    Eigen::VectorXd raw;  ///< x + W L^-1 nu
    Eigen::MatrixXd W;    ///< P H' L^-T, N x 2m
    Eigen::VectorXd x;    ///< raw with its quaternions normalised
};
[[nodiscard]] MONOSLAM_FILTER_EXPORT EkfCorrection
ekfCorrection(const Belief& prior, const Prediction& prediction,
              const std::vector<PixelMeasurement>& pixels, int* faults = nullptr);
[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief applyCorrection(Belief prior,
                                                            const EkfCorrection& correction);

/** Only the mean of that correction: x + P H' S^-1 nu, quaternions normalised; O(N m). */
[[nodiscard]] MONOSLAM_FILTER_EXPORT Eigen::VectorXd ekfUpdateMean(
    const Belief& prior, const Prediction& prediction, const std::vector<PixelMeasurement>& pixels);

/** Joint S = H P H' + block-diag(R) [px^2] and nu = z - h [px] of some pixels. */
struct JointInnovation
{
    Eigen::VectorXd nu;
    Eigen::MatrixXd S;
};
[[nodiscard]] MONOSLAM_FILTER_EXPORT JointInnovation
stackInnovation(const Prediction& prediction, const std::vector<PixelMeasurement>& pixels);

/** Normalises the camera's and the clones' quaternions; P with them (algorithms 1.4). */
MONOSLAM_FILTER_EXPORT void normalizeQuaternions(Belief& belief);
}  // namespace monoslam
