// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "monoslam_models/Camera.h"
#include "monoslam_models/ConstantVelocity.h"
#include "monoslam_models/export.h"

/** Landmark on a ray: y = (x0, y0, z0, theta, phi, rho), the anchor [m], the azimuth and elevation
 *  of the ray [rad] in the world, and the inverse of the distance from the anchor [1/m]. */
namespace monoslam
{
namespace inverse_depth
{
inline constexpr Eigen::Index kAnchor = 0;
inline constexpr Eigen::Index kTheta = 3;
inline constexpr Eigen::Index kPhi = 4;
inline constexpr Eigen::Index kRho = 5;
inline constexpr Eigen::Index kSize = 6;
}  // namespace inverse_depth

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix36d = Eigen::Matrix<double, 3, 6>;
using Matrix32d = Eigen::Matrix<double, 3, 2>;

/** m(theta, phi) = (cos phi sin theta, -sin phi, cos phi cos theta). */
[[nodiscard]] MONOSLAM_MODELS_EXPORT Eigen::Vector3d rayDirection(double theta, double phi,
                                                                  Matrix32d* J_m_angles = nullptr);

/** (theta, phi) of a direction g of any length. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT Eigen::Vector2d rayAngles(const Eigen::Vector3d& g,
                                                               Matrix23d* J_angles_g = nullptr);

/** p = y0 + m(theta, phi) / rho, rho > 0. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT Eigen::Vector3d toPoint(const Vector6d& y,
                                                             Matrix36d* J_p_y = nullptr);

/** L_d = 4 sigma_d |cos a| / d1, with sigma_d = sigma_rho / rho^2, a the angle between the rays
 *  from the anchor and from r_wc to the point, d1 its distance from r_wc (Civera 2008;
 *  algorithms 2.4). */
[[nodiscard]] MONOSLAM_MODELS_EXPORT double linearityIndex(const Vector6d& y, double sigma_rho,
                                                           const Eigen::Vector3d& r_wc);

/** New landmark on the ray of a pixel, and where it came from. */
struct UndelayedLandmark
{
    Vector6d y;
    Eigen::Matrix<double, 6, 7> J_y_pose;  ///< d y / d(r_wc, q_wc)
    Eigen::Matrix<double, 6, 3> J_y_z;     ///< d y / d(u, v, rho)
};

/** Undelayed initialisation (Montiel, Civera; algorithms 2.3).
 *  \return nothing if the pixel cannot be unprojected */
[[nodiscard]] MONOSLAM_MODELS_EXPORT std::optional<UndelayedLandmark> initializeUndelayed(
    const Camera& camera, const Vector7d& pose, const Eigen::Vector2d& uv_px, double rho0);
}  // namespace monoslam
