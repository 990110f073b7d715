// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_filter/Belief.h"
#include "monoslam_filter/smoothWindow.h"
#include "monoslam_models/ConstantVelocity.h"

namespace monoslam
{
/** A smoothed window and what it does not say of itself. */
struct WindowEstimate
{
    SmoothedWindow smoothed;
    std::vector<LandmarkId> ids;  ///< of its landmarks
    std::vector<bool> keep;       ///< those that enter the belief
    double share = 1.0;           ///< its views among all that saw the landmarks
    double dt_s = 0.0;            ///< between its last two views
    bool metric = false;          ///< its points define the world, not its first pose
};

/** The belief of the camera at the window's last view and of the landmarks kept.
 *
 *     x_v = (r, q, (r - r') / dt, log(q'* q) / dt),   P = J P_window J'
 *
 * with ' the last view but one; Q of the last step is added to the velocities. */
[[nodiscard]] Belief beliefFromWindow(const WindowEstimate& estimate,
                                      const ConstantVelocityOptions& motion);
}  // namespace monoslam
