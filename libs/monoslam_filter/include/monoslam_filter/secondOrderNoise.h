// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "monoslam_filter/Belief.h"
#include "monoslam_filter/export.h"
#include "monoslam_filter/predictMeasurements.h"
#include "monoslam_models/Camera.h"

namespace monoslam
{
/** Covariance of the pixel that linearisation leaves out of H P H': an inverse-depth landmark is
 *  seen along h_c = R'(rho d + m) with d = y0 - r, and both rho and d are uncertain.
 *
 *      Var(d_rho * d_d) = P_rho,rho P_dd + P_d,rho P_d,rho',    A = J_uv_hc R'
 *      R_2 = A Var(d_rho * d_d) A'                                                       [px^2]
 *
 * Exact for a product of Gaussians. At a start, where d is about 0, H does not see rho at all and
 * an update without R_2 takes the spread of the depths for motion. Zero for points. O(1).
 * \see Bar-Shalom, Li and Kirubarajan, "Estimation with Applications to Tracking and Navigation",
 * on the second-order EKF */
[[nodiscard]] MONOSLAM_FILTER_EXPORT Eigen::Matrix2d secondOrderNoise(
    const Belief& belief, const Camera& camera, const PredictedLandmark& landmark);
}  // namespace monoslam
