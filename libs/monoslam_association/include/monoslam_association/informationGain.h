// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "monoslam_association/export.h"
#include "monoslam_models/ConstantVelocity.h"

namespace monoslam
{
/** Mutual information of a pixel and the whole state [bit].
 *
 *      M = 1/2 log2(|P| / |P - K S K'|) = 1/2 log2(|S| / |R|)         (determinant lemma)
 *
 * The second form needs no regular P, which a quaternion in the state rules out.
 * \param S  H P H' + R [px^2]; \return 0 if S or R has no positive determinant
 * \see Davison, "Active search for real-time vision", ICCV 2005 */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT double informationAboutState(const Eigen::Matrix2d& S,
                                                                       const Eigen::Matrix2d& R);

/** Mutual information of pixels and the camera pose alone [bit].
 *
 *      M = 1/2 log2(|S| / |S - C' P_xx^+ C|),   C = Cov(pose, z)
 *
 * P_xx is taken in the six numbers (dr, dtheta) of a pose error; directions without variance are
 * left out. Made once per pose covariance, then O(1) per pixel. */
class MONOSLAM_ASSOCIATION_EXPORT PoseInformation
{
   public:
    /** \param pose  (r_wc, q_wc); \param P_xx  7 x 7, its covariance, null along q */
    PoseInformation(const Vector7d& pose, const Eigen::Matrix<double, 7, 7>& P_xx);

    /** \param C  7 x 2 [m px] and [px]; \param S  of the pixel [px^2]
     *  \return 0 if S has no positive determinant, infinite if the pose fixes the pixel */
    [[nodiscard]] double operator()(const Eigen::Matrix<double, 7, 2>& C,
                                    const Eigen::Matrix2d& S) const;

   private:
    Eigen::Matrix<double, 6, 7> whitening_;  ///< B with B'B = P_xx^+
};
}  // namespace monoslam
