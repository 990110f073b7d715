// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "monoslam_models/ConstantVelocity.h"
#include "monoslam_slam/MonoSlam.h"

namespace monoslam
{
/** Images of one rendered sequence with their exact poses. */
struct RenderedSequence
{
    std::string folder;
    CameraParameters camera;
    std::vector<double> times_s;
    std::vector<std::string> images;
    std::vector<Vector7d> poses;  ///< (r_wc, q_wc) of each image
};

/** Reads camera.yaml, rgb.txt and groundtruth.txt of a folder.
 *  \throw std::exception naming the file that is missing or damaged, or an image without a pose */
[[nodiscard]] RenderedSequence readRenderedSequence(const std::string& folder);

struct RunSettings
{
    std::string configFile;
    std::vector<std::string> overrides;  ///< section.key=value
    std::string strategy = "hohct";
    unsigned seed = 1;
};

using FrameVisitor =
    std::function<void(const Frame& frame, const FrameReport& report, const MonoSlam& slam)>;

/** Runs the whole pipeline over a sequence, one call a frame. */
void runSequence(const RenderedSequence& sequence, const RunSettings& settings,
                 const FrameVisitor& visit);
}  // namespace monoslam
