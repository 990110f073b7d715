// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "LandmarkRecord.h"
#include "monoslam_slam/FrameReport.h"

namespace monoslam
{
/** The landmarks of a belief with what is remembered of them.
 *  \throw std::out_of_range if one has no record */
[[nodiscard]] std::vector<MapLandmark> listLandmarks(const Belief& belief,
                                                     const LandmarkRecords& records);
}  // namespace monoslam
