// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_eval/SimulationOptions.h"
#include "monoslam_eval/export.h"

namespace monoslam
{
/** What a simulated camera saw, and the truth. */
struct Simulation
{
    CameraParameters camera;
    std::vector<Vector13d> path;             ///< the true x_v of every frame
    std::vector<PixelFrame> frames;          ///< with the truth of every feature
    std::vector<Eigen::Vector3d> landmarks;  ///< p_w of landmark i in the first frame [m]
    std::vector<LandmarkId> wrongGroup;      ///< [wrong_matches]; empty if there is none
    std::vector<LandmarkId> moved;           ///< [moving]
};

/** The world, the path and all frames of a seed.
 *
 * The path begins at the origin and looks along +z. Landmarks are drawn in view of the camera at
 * random times, their inverse distances uniform. A group of wrong matches is what lies next to a
 * random landmark in the image of its first frame; neither it nor those that move are the target's.
 * The path, the landmarks and the noise are the same with a group and without.
 * \throw std::invalid_argument if the group or the moving ones are more than are in view */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Simulation simulate(const SimulationOptions& options,
                                                       unsigned seed);
}  // namespace monoslam
