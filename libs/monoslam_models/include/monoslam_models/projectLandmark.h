// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "monoslam_models/InverseDepth.h"
#include "monoslam_models/export.h"

namespace monoslam
{
enum class LandmarkKind
{
    InverseDepth,  ///< six numbers
    Point,         ///< three numbers, the point in the world [m]
};

[[nodiscard]] constexpr Eigen::Index landmarkSize(LandmarkKind kind)
{
    return kind == LandmarkKind::InverseDepth ? inverse_depth::kSize : 3;
}

/** Pixel of a landmark and its Jacobians; only the first landmarkSize() columns of J_h_y count. */
struct ProjectedLandmark
{
    Eigen::Vector2d h;                    ///< [px], may lie outside the image
    Eigen::Matrix<double, 2, 13> J_h_xv;  ///< velocities matter for rolling shutter only
    Eigen::Matrix<double, 2, 6> J_h_y;
};

/** h(x_v, y): scaled camera-frame vector R'(rho (y0 - r) + m) or R'(y - r), then Camera::project
 *  (algorithms 2.1). With Camera readout_s > 0 the pose is that of the landmark's row,
 *  r + v s and q (x) exp(omega s) with s = (row / height - 1/2) readout_s, found by Newton steps;
 *  the Jacobians, by implicit differentiation, then reach v and omega.
 *  \param y  six or three numbers, as kind says
 *  \return nothing behind the camera or beyond the camera's valid angle */
[[nodiscard]] MONOSLAM_MODELS_EXPORT std::optional<ProjectedLandmark> projectLandmark(
    const Camera& camera, const Vector13d& x_v, LandmarkKind kind,
    const Eigen::Ref<const Eigen::VectorXd>& y);

/** Only the pixel, without Jacobians. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT std::optional<Eigen::Vector2d> projectPixel(
    const Camera& camera, const Vector13d& x_v, LandmarkKind kind,
    const Eigen::Ref<const Eigen::VectorXd>& y);
}  // namespace monoslam
