// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_association/Associator.h"
#include "monoslam_filter/Belief.h"
#include "monoslam_models/Camera.h"

namespace monoslam
{
/** Finds out whether, and how slowly, a shutter rolls, from the residuals after each update.
 *
 * A readout of tau shifts a pixel in row v by j tau, j = (v / height - 1/2) (dh/dr v + dh/dtheta
 * omega).  Each frame's residuals are regressed on the pose (6 numbers, eliminated) and tau:
 *
 *     e = J_p dx + j (tau - tau_used),   Lambda += j' M j,   eta += j' M (e + j tau_used),
 *     M = 1 - J_p (J_p' J_p)^-1 J_p',    tau = eta / Lambda
 *
 * Velocities and landmarks have yielded to most of a wrong tau, so that e shows a part of it only:
 * with tau fed back it converges within seconds. */
class ReadoutEstimator
{
   public:
    /** The readout known beforehand [s], to the length of a few frames' evidence. */
    void startAt(double readout_s);

    /** Residuals of the matched pairs of a belief just updated.
     *  \param camera whose readout_s the belief was updated with
     *  \param noise_px of a residual */
    void observe(const Belief& belief, const Camera& camera,
                 const std::vector<Association>& associations, double noise_px);

    /** The readout to use [s]: 0 as long as the shutter may be global. */
    [[nodiscard]] double readout_s() const;

   private:
    double information_ = 0.0;  ///< Lambda [1/s^2]
    double eta_ = 0.0;
};
}  // namespace monoslam
