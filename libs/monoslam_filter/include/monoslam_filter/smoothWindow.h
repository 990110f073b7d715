// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "monoslam_filter/export.h"
#include "monoslam_models/Camera.h"
#include "monoslam_models/ConstantVelocity.h"
#include "monoslam_models/projectLandmark.h"

namespace monoslam
{
/** A landmark of a window: three free numbers, (theta, phi, rho) from a fixed anchor, or x y z. */
struct WindowLandmark
{
    LandmarkKind kind = LandmarkKind::InverseDepth;
    Eigen::VectorXd y;                                           ///< six or three numbers
    Eigen::Vector3d priorMean = Eigen::Vector3d::Zero();         ///< of the free numbers
    Eigen::Vector3d priorInformation = Eigen::Vector3d::Zero();  ///< 1 / variance, 0 = none
};

struct WindowObservation
{
    Eigen::Index view = 0;
    Eigen::Index landmark = 0;
    Eigen::Vector2d z;  ///< [px]
    Eigen::Matrix2d R;  ///< [px^2]
};

/** Some views of one moving camera, what they saw, and what is known beforehand. */
struct Window
{
    std::vector<Vector7d> poses;  ///< (r_wc, q_wc) of each view, first guess
    std::vector<WindowLandmark> landmarks;
    std::vector<WindowObservation> observations;
    Eigen::Matrix<double, 6, 6> firstPoseInformation =
        Eigen::Matrix<double, 6, 6>::Zero();  ///< of (dr in the world, dtheta in the camera)
    double scaleSigma = 0.0;  ///< > 0: the distance of the last view from the first is known to
                              ///< this relative std, which fixes a free unit
};

struct WindowOptions
{
    int maxIterations = 10;
    double convergence = 1e-3;     ///< relative decrease of the cost at which to stop
    double huber_sigmas = 2.0;     ///< residuals beyond are weighted down
    double outlierChi2 = 13.8155;  ///< chi2(2, 0.999): beyond, the pair is no measurement
    double hopelessCost = std::numeric_limits<double>::infinity();  ///< not usable if it is beyond
        ///< this before outliers are left out
    bool covariance = true;  ///< whether P is wanted
};

struct SmoothedWindow
{
    std::vector<Vector7d> poses;
    std::vector<WindowLandmark> landmarks;
    std::vector<bool> inlier;  ///< of each observation
    bool usable = false;       ///< false if the pixels leave some view or landmark undetermined
    double cost = 0.0;         ///< halved squared sigmas, each cut at the outlier threshold
    double meanChi2 = 0.0;     ///< of the inliers, 2 when all is well
    int iterations = 0;
    /** Covariance of (dr, dtheta) of the first view, of the last but one and of the last, then of the
     *  three free numbers of each landmark; empty if it was not wanted. */
    Eigen::MatrixXd P;
};

/** Maximum a posteriori poses and landmarks of a window: Levenberg-Marquardt on all pixels with a
 *  Huber weight, landmarks eliminated by the Schur complement.
 *
 *     S = H_pp - sum_i H_pi H_ii^-1 H_ip,    cov_pp = S^-1,    G_i = H_ii^-1 H_ip,
 *     cov_ij = delta_ij H_ii^-1 + G_i cov_pp G_j'
 *
 * Unlike the filter it linearises everything at the final estimate.
 * \throw std::invalid_argument with fewer than two views */
[[nodiscard]] MONOSLAM_FILTER_EXPORT SmoothedWindow smoothWindow(const Camera& camera,
                                                                 Window window,
                                                                 const WindowOptions& options = {});
}  // namespace monoslam
