// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_slam/MetricStart.h"
#include "refinePose.h"

namespace monoslam
{
struct PlanarSolution
{
    MetricPose pose;
    double chi2 = 0.0;  ///< weighted squared residual; 2 n - 6 degrees of freedom
};

/** Poses, best first, at local minima of the reprojection error of a planar target.
 *
 * OpenCV's IPPE gives the two tilts that a planar target allows; each is refined on the distorted
 * pixels with weights R_i = sigma_i^2 I + J_p (point_sigma^2 I) J_p', and duplicates are merged.
 * Covariance (algorithms 3.9): C6 = (sum J_i' R_i^-1 J_i)^-1 of (dr, dtheta), R_wc = R exp(dtheta).
 * \return up to two solutions; none if the target is degenerate or behind the camera */
[[nodiscard]] std::vector<PlanarSolution> solvePlanarPose(const SeenPoints& seen,
                                                          const Camera& camera);

/** The best solution if it fits and no other one fits nearly as well. */
[[nodiscard]] MetricStartResult unambiguousPose(const std::vector<PlanarSolution>& solutions);

/** Largest chi2 (2 degrees of freedom) of four points that fit, and how much worse the runner-up
 *  has to be: exp(-9 / 2) are odds of 1 to 90. */
inline constexpr double kFittingChi2 = 25.0;
inline constexpr double kAmbiguousChi2 = 9.0;
}  // namespace monoslam
