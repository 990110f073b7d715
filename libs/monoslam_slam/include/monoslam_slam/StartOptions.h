// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_slam/export.h"

namespace monoslam
{
class ConfigSection;

/** Re-estimation of the first seconds, ini section [start]. */
struct MONOSLAM_SLAM_EXPORT StartOptions
{
    std::vector<double> parallax_deg{0.5, 1.0, 2.0, 4.0,
                                     8.0};  ///< medians at which it happens; empty = never
    int views = 14;                         ///< of the window, evenly spaced
    int max_frames = 200;                   ///< after which the window closes
    int min_sightings = 3;                  ///< of a landmark that stays
    double min_inlier_ratio = 0.6;          ///< of its pixels
    double good_inlier_ratio = 0.98;   ///< fewer: others are tried too, as always at small parallax
    double accept_inlier_ratio = 0.8;  ///< fewer still: the filter's own belief stays
    double point_sigma = 0.0005;       ///< of known points, from [metric_start] [unit]

    static StartOptions from(ConfigSection section);
};
}  // namespace monoslam
