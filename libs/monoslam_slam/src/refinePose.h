// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "monoslam_models/Camera.h"

namespace monoslam
{
/** Known points and where they were seen. */
struct SeenPoints
{
    std::vector<Eigen::Vector3d> points_m;   ///< world, four or more
    std::vector<Eigen::Vector2d> pixels_px;  ///< distorted, same order
    std::vector<double> sigmas_px;           ///< of each pixel coordinate
    double point_sigma_m = 0.0;              ///< of each world coordinate
};

struct CameraPose
{
    Eigen::Matrix3d R_wc;
    Eigen::Vector3d r_wc;
};

/** One point's share of the normal equations at a pose.
 *
 *      nu = uv - h(pose, p),   R = sigma^2 I + J_p (point_sigma^2 I) J_p' */
struct PointTerm
{
    Eigen::Vector2d nu;
    Eigen::Matrix<double, 2, 6> J_uv_pose;  ///< over (dr, dtheta), R_wc exp(dtheta)
    Eigen::Matrix<double, 2, 3> J_uv_p;     ///< over the point in the world
    Eigen::Matrix2d weight;                 ///< R^-1
};

/** \return nothing if a point cannot be projected */
[[nodiscard]] std::optional<std::vector<PointTerm>> pointTerms(const SeenPoints& seen,
                                                               const Camera& camera,
                                                               const CameraPose& pose);

[[nodiscard]] double chi2Of(const std::vector<PointTerm>& all);

/** sum J' R^-1 J. */
[[nodiscard]] Eigen::Matrix<double, 6, 6> informationOf(const std::vector<PointTerm>& all);

/** The next local minimum of chi2, by Levenberg-Marquardt. */
[[nodiscard]] std::optional<CameraPose> refinePose(const SeenPoints& seen, const Camera& camera,
                                                   CameraPose pose);
}  // namespace monoslam
