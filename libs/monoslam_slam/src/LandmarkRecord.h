// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "monoslam_filter/Belief.h"
#include "monoslam_vision/Patch.h"

namespace monoslam
{
/** How a landmark fared in one belief. */
struct TrackRecord
{
    long lastSeen = 0;
    int searched = 0;
    int found = 0;
    int matched = 0;
    std::vector<long> strikes;  ///< frames of recent rejections
};
using TrackRecords = std::map<LandmarkId, TrackRecord>;

/** What the pipeline remembers of a landmark beside its place in the state; the track record is that
 *  of the belief of largest weight. */
struct LandmarkRecord : TrackRecord
{
    Appearance born;
    long bornFrame = 0;                    ///< of its appearance
    double variance_px2 = 0.0;             ///< of its matches beyond the alignment's own, per axis
    std::optional<Eigen::Vector3d> known;  ///< where a point of the metric target is [m]
};

using LandmarkRecords = std::map<LandmarkId, LandmarkRecord>;
}  // namespace monoslam
