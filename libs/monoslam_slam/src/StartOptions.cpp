// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/StartOptions.h"

#include "optionRanges.h"

namespace monoslam
{
StartOptions StartOptions::from(ConfigSection section)
{
    StartOptions o;
    o.parallax_deg = section.get("parallax_deg", o.parallax_deg);
    for (const double parallax : o.parallax_deg)
        if (!(parallax > 0.0 && parallax < 60.0))
            section.fail("parallax_deg", "each must lie between 0 and 60");
    o.views = section.get("views", o.views, {4, 100});
    o.max_frames = section.get("max_frames", o.max_frames, {4, 100000});
    o.min_sightings = section.get("min_sightings", o.min_sightings, {2, 100});
    o.min_inlier_ratio = section.get("min_inlier_ratio", o.min_inlier_ratio, kRatio);
    o.accept_inlier_ratio = section.get("accept_inlier_ratio", o.accept_inlier_ratio, kRatio);
    o.good_inlier_ratio = section.get("good_inlier_ratio", o.good_inlier_ratio, kRatio);
    section.rejectUnknownKeys();
    return o;
}
}  // namespace monoslam
