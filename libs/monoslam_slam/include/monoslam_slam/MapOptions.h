// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_slam/export.h"

namespace monoslam
{
class ConfigSection;

/** What stays in the map, ini section [map]. */
struct MONOSLAM_SLAM_EXPORT MapOptions
{
    int measured_target = 50;  ///< landmarks to be measured in a frame
    int max_landmarks = 100;
    double min_found_ratio = 0.5;  ///< found / searched, after min_searched searches
    int min_searched = 5;
    bool delete_on_reject = false;  ///< on_reject = delete (the first paper) | strike
    int strikes = 3;                ///< rejections within strike_frames that remove a landmark
    int strike_frames = 10;
    double convert_linearity = 0.02;       ///< inverse depth to point below this index; 0 = never
    int min_matched = 5;                   ///< fewer: degraded; the frame may only predict
    double degraded_rejected_share = 0.3;  ///< of the pairs, running mean, beyond which the state
                                           ///< says degraded
    double degraded_residual_px = 0.75;    ///< the same for the noise that the residuals show
    int lost_after = 5;                    ///< such frames in a row until the state says lost
    int relocalize_every = 5;  ///< frames between two looks for a map that was lost; 0 = never

    static MapOptions from(ConfigSection section);
};
}  // namespace monoslam
