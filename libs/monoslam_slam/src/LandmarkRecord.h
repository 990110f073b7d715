// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "monoslam_filter/Belief.h"
#include "monoslam_vision/Patch.h"

namespace monoslam
{
/** What the pipeline remembers of a landmark beside its place in the state. */
struct LandmarkRecord
{
    Appearance born;
    long bornFrame = 0;  ///< of its appearance
    long lastSeen = 0;
    int searched = 0;
    int found = 0;
    int matched = 0;
    std::vector<long> strikes;  ///< frames of recent rejections
    double variance_px2 = 0.0;  ///< of its matches beyond the alignment's own, per axis
    bool known = false;         ///< a point of the metric target
};

using LandmarkRecords = std::map<LandmarkId, LandmarkRecord>;
}  // namespace monoslam
