// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "monoslam_vision/export.h"

namespace monoslam
{
/** A slope and what is known of it, for one frame. */
struct SlopeEstimate
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();  ///< inverse covariance
};

/** What the matches so far have told of the slope of a landmark's surface.
 *
 * The surface is a small plane with normal n ~ a + B s, where a is the unit ray from the birth
 * camera, B has two axes across it (axesAcross) and the slope s is the tangent of the angle between
 * them.  The warp of a patch is linear in s to first order, so that every alignment is a linear
 * measurement of s (Molton, Davison and Reid, "Locally planar patch features", BMVC 2004). */
class MONOSLAM_VISION_EXPORT SurfaceSlope
{
   public:
    /** Posterior with a wide prior around \p expected: a surface that was seen from two sides is
     *  likelier to face both. */
    [[nodiscard]] SlopeEstimate around(const Eigen::Vector2d& expected) const;

    /** Adds one measurement from pixels. Its errors repeat from frame to frame (they are those of
     *  the one birth image), so that it counts for a part only and the sum is bounded. */
    void learn(const SlopeEstimate& measured);

    [[nodiscard]] const Eigen::Matrix2d& information() const { return information_; }

   private:
    Eigen::Matrix2d information_ = Eigen::Matrix2d::Zero();
    Eigen::Vector2d eta_ = Eigen::Vector2d::Zero();  ///< information times mean
};

/** Two orthonormal axes across a unit ray, 3 x 2. */
[[nodiscard]] MONOSLAM_VISION_EXPORT Eigen::Matrix<double, 3, 2> axesAcross(
    const Eigen::Vector3d& ray);
}  // namespace monoslam
