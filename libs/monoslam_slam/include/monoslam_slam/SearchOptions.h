// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_slam/export.h"

namespace monoslam
{
class ConfigSection;

/** Active search of landmarks, ini section [search]. */
struct MONOSLAM_SLAM_EXPORT SearchOptions
{
    int patch_px = 13;  ///< side, odd, 5 to 31
    double min_zncc = 0.8;
    double max_radius_px = 60.0;  ///< a larger ellipse is clipped, never refused
    bool subpixel = true;
    double sigma_px = 1.0;         ///< of a match without sub-pixel alignment
    double sigma_floor_px = 0.15;  ///< of a match with it, in quadrature with the alignment's own
    double max_sigma_floor_px = 1.5;  ///< the floor follows the residuals up to here; the same as
                                      ///< sigma_floor_px: it does not
    double smoothing_px = 0.7;        ///< of every image
    double max_scale = 2.0;           ///< change of a patch's size since birth
    double max_view_angle_deg = 45.0;

    static SearchOptions from(ConfigSection section);
};
}  // namespace monoslam
