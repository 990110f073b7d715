// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "monoslam_models/Camera.h"
#include "monoslam_models/ConstantVelocity.h"
#include "monoslam_models/export.h"

namespace monoslam
{
/** Pose s seconds after the middle row of a frame, and how it depends on s and the camera state. */
struct RowPose
{
    Vector7d pose;  ///< (r + v s, q (x) exp(omega s))
    Vector7d J_pose_s;
    Eigen::Matrix<double, 7, 13> J_pose_xv;
};

[[nodiscard]] MONOSLAM_MODELS_EXPORT RowPose poseAfter(const Vector13d& x_v, double s);

/** Time of a row after the middle one [s]: (v / height - 1/2) readout_s; 0 with a global shutter. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT double rowTime_s(const Camera& camera, double v_px);

/** The pixel that a global shutter at the frame's time would have taken of what a rolling one took
 *  at uv_px, for a point 1 / rho away; the same pixel with a global shutter.
 *  \return nothing if the pixel cannot be unprojected or the point leaves the view */
[[nodiscard]] MONOSLAM_MODELS_EXPORT std::optional<Eigen::Vector2d> globalPixel(
    const Camera& camera, const Vector13d& x_v, const Eigen::Vector2d& uv_px, double rho);
}  // namespace monoslam
