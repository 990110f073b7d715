// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monoslam_mrpt/RawlogContents.h"

namespace monoslam
{
/** Reads T_world_camera from a TUM text (t tx ty tz qx qy qz qw), an EuRoC csv (ns, position,
 *  quaternion w first, of the body, composed with cameraPose) or KITTI's 12 numbers, one line an
 *  image.
 *  \param imageTimes  of KITTI's lines
 *  \throw std::runtime_error naming file and line */
[[nodiscard]] std::vector<RecordedPose> readTruth(const std::string& file,
                                                  const mrpt::poses::CPose3D& cameraPose,
                                                  const std::vector<Ticks>& imageTimes);
}  // namespace monoslam
