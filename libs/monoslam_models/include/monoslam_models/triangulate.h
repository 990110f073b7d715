// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "monoslam_models/InverseDepth.h"
#include "monoslam_models/export.h"

namespace monoslam
{
/** One view of a point: the camera pose (r_wc, q_wc) and the distorted pixel. */
struct View
{
    Vector7d pose;
    Eigen::Vector2d uv_px;
};

/** Delayed inverse depth from a first view and the current one, anchored at the current camera. */
struct Triangulation
{
    Vector6d y;                             ///< (r, theta, phi, rho) of the current view
    double alpha_rad = 0.0;                 ///< parallax
    double beta_rad = 0.0;                  ///< angle(first ray, B)
    double gamma_rad = 0.0;                 ///< angle(current ray, -B)
    double baseline = 0.0;                  ///< |B| [m]
    double epipolarResidual_rad = 0.0;      ///< |g1 . (B x g2)| / (|g1 x B| |g2|)
    Eigen::Matrix<double, 6, 9> J_current;  ///< d y / d(r, q, u, v)
    Eigen::Matrix<double, 6, 9> J_first;    ///< d y / d(r0, q0, u0, v0)
};

/** rho = sin(alpha) / (b sin(beta)), alpha = pi - beta - gamma (DI-D; algorithms 3.5, 3.7).
 *  \return nothing if a pixel cannot be unprojected, b = 0, a ray is parallel to B, alpha <= 0 */
[[nodiscard]] MONOSLAM_MODELS_EXPORT std::optional<Triangulation> triangulate(const Camera& camera,
                                                                              const View& first,
                                                                              const View& current);
}  // namespace monoslam
