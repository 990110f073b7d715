// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/SearchOptions.h"

#include "optionRanges.h"

namespace monoslam
{
SearchOptions SearchOptions::from(ConfigSection section)
{
    SearchOptions o;
    o.patch_px = section.get("patch_px", o.patch_px, {5, 31});
    if (o.patch_px % 2 == 0) section.fail("patch_px", "must be odd");
    o.min_zncc = section.get("min_zncc", o.min_zncc, kRatio);
    o.max_radius_px = section.get("max_radius_px", o.max_radius_px, {2.0, 1000.0});
    o.subpixel = section.get("subpixel", o.subpixel);
    o.sigma_px = section.get("sigma_px", o.sigma_px, {0.01, 100.0});
    o.sigma_floor_px = section.get("sigma_floor_px", o.sigma_floor_px, {0.0, 100.0});
    o.max_sigma_floor_px = section.get("max_sigma_floor_px", o.max_sigma_floor_px, {0.0, 100.0});
    o.smoothing_px = section.get("smoothing_px", o.smoothing_px, {0.0, 3.0});
    o.max_scale = section.get("max_scale", o.max_scale, {1.05, 10.0});
    o.max_view_angle_deg = section.get("max_view_angle_deg", o.max_view_angle_deg, {1.0, 85.0});
    section.rejectUnknownKeys();
    return o;
}
}  // namespace monoslam
