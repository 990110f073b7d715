// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "monoslam_models/Camera.h"
#include "monoslam_models/ConstantVelocity.h"
#include "monoslam_models/export.h"
#include "monoslam_models/projectLandmark.h"

namespace monoslam
{
/** A pose with its rotation at hand, for many projections from it. */
struct MONOSLAM_MODELS_EXPORT ViewPose
{
    explicit ViewPose(const Vector7d& pose);  ///< (r_wc, q_wc)

    Eigen::Matrix3d R_cw;
    Eigen::Vector3d r_wc;
};

/** A landmark with its ray at hand, for many projections of it. */
struct MONOSLAM_MODELS_EXPORT LandmarkRay
{
    LandmarkRay(LandmarkKind form, const Eigen::Ref<const Eigen::VectorXd>& y);

    LandmarkKind kind;
    Eigen::Vector3d from_w;  ///< anchor, or the point
    double rho = 1.0;        ///< 1 for a point
    Eigen::Vector3d m_w;     ///< unit ray from the anchor, 0 for a point
    Matrix32d J_m_angles;    ///< of m_w to (theta, phi), 0 for a point
};

struct TangentProjection
{
    Eigen::Vector2d h;                         ///< [px]
    Eigen::Matrix<double, 2, 6> J_h_pose;      ///< to (dr in the world, dtheta in the camera)
    Eigen::Matrix<double, 2, 3> J_h_landmark;  ///< to (theta, phi, rho) or to x y z
};

/** projectLandmark() for window estimates: minimal pose increments, R_wc exp(dtheta), a fixed
 *  anchor, and the whole image taken at once.
 *
 *     d_c = R_cw (rho (y0 - r) + m),  dh/ddr = -rho A R_cw,  dh/ddtheta = A [d_c]x,
 *     dh/d(theta, phi, rho) = A R_cw [dm, y0 - r],  A = dh/dd_c
 *
 *  \return nothing behind the camera or beyond the lens model */
[[nodiscard]] MONOSLAM_MODELS_EXPORT std::optional<TangentProjection> projectOnTangent(
    const Camera& camera, const ViewPose& view, const LandmarkRay& landmark);

/** Its pixel alone. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT std::optional<Eigen::Vector2d> projectRay(
    const Camera& camera, const ViewPose& view, const LandmarkRay& landmark);
}  // namespace monoslam
