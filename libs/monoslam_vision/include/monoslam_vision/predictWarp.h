// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "monoslam_models/Camera.h"
#include "monoslam_vision/Patch.h"
#include "monoslam_vision/export.h"

namespace monoslam
{
/** Limits beyond which an appearance cannot be predicted. */
struct WarpLimits
{
    double maxScale = 2.0;          ///< and not below its inverse
    double maxViewAngle_rad = 0.8;  ///< between the two viewing directions
};

/** The warp of a small plane through p_w with the slope learnt so far, around the bisector of both
 *  viewing directions where nothing is; finite differences of the full projection, lens included
 *  (algorithms 4.3).
 *  \return nothing if the view has changed too much */
[[nodiscard]] MONOSLAM_VISION_EXPORT std::optional<PredictedWarp> predictWarp(
    const Camera& camera, const Appearance& born, const Vector7d& pose, const Eigen::Vector3d& p_w,
    const WarpLimits& limits);
}  // namespace monoslam
