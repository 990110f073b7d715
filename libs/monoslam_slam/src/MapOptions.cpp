// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/MapOptions.h"

#include "optionRanges.h"

namespace monoslam
{
MapOptions MapOptions::from(ConfigSection section)
{
    MapOptions o;
    o.measured_target = section.get("measured_target", o.measured_target, {4, 1000});
    o.max_landmarks = section.get("max_landmarks", o.max_landmarks, {4, 2000});
    o.min_found_ratio = section.get("min_found_ratio", o.min_found_ratio, kRatio);
    o.min_searched = section.get("min_searched", o.min_searched, {1, 1000});
    o.delete_on_reject =
        section.get<bool>("on_reject", o.delete_on_reject, {{"delete", true}, {"strike", false}});
    o.strikes = section.get("strikes", o.strikes, {1, 1000});
    o.strike_frames = section.get("strike_frames", o.strike_frames, {1, 10000});
    o.convert_linearity = section.get("convert_linearity", o.convert_linearity, {0.0, 10.0});
    o.min_matched = section.get("min_matched", o.min_matched, {1, 1000});
    o.degraded_rejected_share =
        section.get("degraded_rejected_share", o.degraded_rejected_share, kRatio);
    o.degraded_residual_px = section.get("degraded_residual_px", o.degraded_residual_px, kFromZero);
    o.lost_after = section.get("lost_after", o.lost_after, {1, 10000});
    o.relocalize_every = section.get("relocalize_every", o.relocalize_every, {0, 10000});
    section.rejectUnknownKeys();
    return o;
}
}  // namespace monoslam
