// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "monoslam_association/Associator.h"
#include "monoslam_association/export.h"

namespace monoslam
{
/** A landmark in view that is not measured yet, seen from the belief as corrected so far. */
struct OpenLandmark
{
    LandmarkSlot slot;
    PredictedLandmark row;              ///< h and S are current, H is of the last linearisation
    Eigen::Matrix<double, 7, 2> C;      ///< Cov(camera pose, h)
    Eigen::Matrix<double, 13, 6> P_vy;  ///< unused columns are zero
    Eigen::Matrix<double, 6, 6> P_yy;
    double moved_px = 0.0;  ///< of h since the last linearisation
};

/** EKF corrections of one belief by one pixel after the other, P carried out at the end.
 *
 *      w = P_k H' L^-T,   S = H P_k H' + R = L L',   x += w L^-1 nu,   P_k+1 = P_k - w w'
 *      P_k H' = A P_0 A' H' - W (W' H'),   A: the normalisations of the camera's quaternion
 *
 * A correction costs O(N k) in the k-th step instead of O(N^2), and the sum of all w w' is one rank
 * update. Every open landmark keeps its own blocks of P_k, so that its S costs O(1) per step. Its h
 * moves linearly, H dx; it is linearised again when it has moved far, and, by linearize(), before
 * it is measured. Equals a sequence of ekfUpdate() with a prediction of its own each. */
class MONOSLAM_ASSOCIATION_EXPORT SequentialUpdate
{
   public:
    /** \param view  must outlive this object */
    SequentialUpdate(Belief predicted, const FrameView& view);

    /** Every landmark in view, by id; one is worth measuring while it is open. */
    [[nodiscard]] const std::vector<OpenLandmark>& landmarks() const { return landmarks_; }
    /** Indices of those that are open, ascending. */
    [[nodiscard]] const std::vector<std::size_t>& open() const { return open_; }

    [[nodiscard]] Vector7d pose() const { return belief_.pose(); }
    [[nodiscard]] const Matrix13d& cameraCovariance() const { return P_vv_; }

    /** h, H and S of a landmark at the current mean; false if it is not visible from there. */
    [[nodiscard]] bool linearize(std::size_t i);
    void close(std::size_t i);

    /** Corrects by one pixel and closes the landmark; false, and nothing else happens, if S is not
     *  positive definite. */
    [[nodiscard]] bool correct(std::size_t i, const Eigen::Vector2d& z, const Eigen::Matrix2d& R);

    [[nodiscard]] Belief finish() &&;

   private:
    using Columns2 = Eigen::Matrix<double, Eigen::Dynamic, 2>;

    void refresh(OpenLandmark& landmark) const;
    [[nodiscard]] Columns2 covarianceWith(const OpenLandmark& landmark) const;
    [[nodiscard]] Eigen::Matrix4d normalizeCamera();
    void follow(OpenLandmark& landmark, const Columns2& w, const Eigen::VectorXd& dx) const;

    Belief belief_;  ///< its P is P_0 until finish()
    const FrameView& view_;
    std::vector<OpenLandmark> landmarks_;
    std::vector<std::size_t> open_;
    Eigen::MatrixXd W_;
    Eigen::Index used_ = 0;  ///< columns of W
    Eigen::Matrix4d A_q_ = Eigen::Matrix4d::Identity();
    Matrix13d P_vv_;
};
}  // namespace monoslam
