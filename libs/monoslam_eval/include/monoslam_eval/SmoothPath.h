// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "monoslam_eval/export.h"
#include "monoslam_models/ConstantVelocity.h"

namespace monoslam
{
/** Seeded 6-DoF path as of a hand-held camera that looks about: every degree of freedom is the sum of
 *  two sines of random rate and phase. It begins at the origin, looking along +z. */
class MONOSLAM_EVAL_EXPORT SmoothPath
{
   public:
    /** \param amplitude_m, amplitude_rad  of the slower sine in a degree of freedom; the faster one
     *  has a third of it */
    SmoothPath(double amplitude_m, double amplitude_rad, unsigned seed);

    /** Pose at t, and the velocities of its central difference. */
    [[nodiscard]] Vector13d at(double t_s) const;

   private:
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    [[nodiscard]] Vector7d pose(double t_s) const;

    Vector6 amplitude_;
    Eigen::Matrix<double, 6, 2> rate_hz_;
    Eigen::Matrix<double, 6, 2> phase_rad_;
};
}  // namespace monoslam
