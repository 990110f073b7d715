// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "monoslam_filter/smoothWindow.h"
#include "monoslam_models/InverseDepth.h"
#include "monoslam_models/projectOnTangent.h"

namespace monoslam
{
/** Cost and normal equations of a window at one estimate.
 *
 *     [H_pp  H_pl] [d_p]   [b_p]
 *     [H_lp  H_ll] [d_l] = [b_l],   H_ll block-diagonal, one 3 x 3 block a landmark
 *
 * d_p: (dr in the world, dtheta in the camera) of every view; d_l: three free numbers a landmark. */
class WindowEquations
{
   public:
    /** Keeps references to all three. */
    WindowEquations(const Camera& camera, const Window& window, const WindowOptions& options);

    /** Robust cost; fills the equations if asked. */
    double evaluate(const Window& at, bool linearize);

    /** Sum of half the squared sigmas, each cut at the outlier threshold: comparable between
     *  estimates of one window. */
    [[nodiscard]] double truncatedCost(const Window& at) const;

    /** Marks what lies beyond the outlier threshold; returns the mean chi2 of the rest. */
    double markOutliers(const Window& at);

    /** Solution of the damped equations applied to a copy of the window. */
    [[nodiscard]] Window step(const Window& at, double lambda) const;

    /** Whether the pixels leave no view undetermined. */
    [[nodiscard]] bool determined() const;

    /** SmoothedWindow::P; empty if the pixels leave a view undetermined. */
    [[nodiscard]] Eigen::MatrixXd covariance() const;
    [[nodiscard]] const std::vector<bool>& inliers() const { return inlier_; }

    static constexpr Eigen::Index kPoseDof = 6;

    /** The first of the three free numbers of a landmark within y. */
    [[nodiscard]] static Eigen::Index freeOffset(LandmarkKind kind)
    {
        return kind == LandmarkKind::InverseDepth ? inverse_depth::kTheta : 0;
    }

   private:
    /** An estimate with rotations and rays at hand. */
    struct Geometry
    {
        explicit Geometry(const Window& at);
        std::vector<ViewPose> views;
        std::vector<LandmarkRay> landmarks;
    };

    /** Lower half of H_pp - H_pl H_ll^-1 H_lp, the diagonals of H_pp and H_ll times 1 + lambda.
     *  \param inverse  becomes the blocks of that H_ll^-1 */
    [[nodiscard]] Eigen::MatrixXd reduced(double lambda,
                                          std::vector<Eigen::Matrix3d>& inverse) const;
    void clear();
    double posePrior(const Window& at, bool linearize);
    double scalePrior(const Window& at, bool linearize);
    double landmarkPrior(const Window& at, std::size_t i, bool linearize);
    double observation(const Geometry& at, std::size_t i, bool linearize);
    /** Adds one whitened row pair of weight w to the equations. */
    void accumulate(const WindowObservation& seen, const Eigen::Matrix2d& whiten,
                    const TangentProjection& projected, const Eigen::Vector2d& e, double w);
    /** Of one pixel; a landmark behind its anchor explains nothing, however well it projects. */
    [[nodiscard]] double squaredSigmas(const Geometry& at, std::size_t i) const;

    const Camera& camera_;
    const Window& window_;
    const WindowOptions& options_;
    Eigen::Index poseSize_;
    std::vector<bool> inlier_;
    std::vector<Eigen::Matrix2d> whiten_;  ///< L^-1 of each pixel's R = L L'
    Vector7d anchor_;
    Eigen::Vector3d baseline_;
    Eigen::MatrixXd H_pp_;
    Eigen::VectorXd b_p_;
    std::vector<Eigen::Matrix3d> H_ll_;
    Eigen::MatrixXd H_pl_;  ///< three columns a landmark
    std::vector<Eigen::Vector3d> b_l_;
};
}  // namespace monoslam
