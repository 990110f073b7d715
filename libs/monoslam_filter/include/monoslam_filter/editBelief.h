// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "monoslam_filter/Belief.h"
#include "monoslam_filter/export.h"
#include "monoslam_models/Camera.h"
#include "monoslam_models/triangulate.h"

/** The only functions that change the layout of a Belief. Each returns the edited value. */
namespace monoslam
{
/** Noise of an undelayed landmark's pixel and inverse depth. */
struct UndelayedPrior
{
    double rho0 = 1.0;       ///< [1/m]
    double sigma_rho = 0.5;  ///< [1/m]
    double sigma_px = 0.3;
};

struct NewLandmark
{
    LandmarkId id = -1;
    Eigen::Vector2d uv_px;
};

/** Appends inverse-depth landmarks seen now (algorithms 2.3), from the pose of their pixels' rows;
 *  those whose pixel cannot be unprojected are left out. The state grows once for all. */
[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief addUndelayed(Belief belief, const Camera& camera,
                                                         const std::vector<NewLandmark>& corners,
                                                         const UndelayedPrior& prior);

/** One of them; nothing if its pixel cannot be unprojected. */
[[nodiscard]] MONOSLAM_FILTER_EXPORT std::optional<Belief> addUndelayed(
    Belief belief, const Camera& camera, LandmarkId id, const Eigen::Vector2d& uv_px,
    const UndelayedPrior& prior);

/** The first view of a delayed candidate: a clone in the state, or the paper's stored pose. */
struct FirstView
{
    CloneId clone = -1;  ///< >= 0: the pose is this clone, with all its correlations
    Vector7d pose;       ///< used when clone < 0: "paper" mode
    Vector7d variance;   ///< diagonal of P at that time, "paper" mode
    Eigen::Vector2d uv_px;
};

/** Appends a triangulated landmark (algorithms 3.7).
 *
 *   clone:  P_yy = J P_(pose, clone) J' + J_uv R J_uv',   P_yx from the joint P
 *   paper:  first pose independent of the state with its stored variances
 *
 * \param sigma_px  of both pixels; \param sigma_floor  sigma_rho >= sigma_floor * rho */
[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief addTriangulated(Belief belief, LandmarkId id,
                                                            const Triangulation& triangulation,
                                                            const FirstView& first, double sigma_px,
                                                            double sigma_floor);

/** Appends a 3-D point with covariance P_p, independent of the state. */
[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief addPoint(Belief belief, LandmarkId id,
                                                     const Eigen::Vector3d& p_w,
                                                     const Eigen::Matrix3d& P_p);

/** Appends any landmark whose joint covariance with the state is known: P_yx is size x N. */
[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief append(Belief belief, LandmarkId id, LandmarkKind kind,
                                                   const Eigen::VectorXd& y,
                                                   const Eigen::MatrixXd& P_yx,
                                                   const Eigen::MatrixXd& P_yy);

[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief removeLandmarks(Belief belief,
                                                            const std::vector<LandmarkId>& ids);

/** Appends a copy of the current pose (r_wc, q_wc). */
[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief addClone(Belief belief, CloneId id);
[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief removeClones(Belief belief,
                                                         const std::vector<CloneId>& ids);

/** Inverse depth to point for every given landmark; one that has rho <= 0 is left as it is. */
[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief convertToPoints(Belief belief,
                                                            const std::vector<LandmarkId>& ids);

/** Multiplies all lengths by s: r, v, points by s, rho by 1/s; P accordingly. */
[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief rescale(Belief belief, double s);
}  // namespace monoslam
