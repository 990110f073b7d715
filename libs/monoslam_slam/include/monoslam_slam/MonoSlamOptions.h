// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monoslam_models/ConstantVelocity.h"
#include "monoslam_slam/MetricStart.h"
#include "monoslam_slam/export.h"
#include "monoslam_vision/CornerTracker.h"
#include "monoslam_vision/detectCorners.h"

namespace mrpt::config
{
class CConfigFileBase;
}

namespace monoslam
{
/** Active search of landmarks, ini section [search]. */
struct MONOSLAM_SLAM_EXPORT SearchOptions
{
    int patch_px = 13;              ///< side, odd, 5 to 31
    double min_zncc = 0.8;
    double max_radius_px = 60.0;    ///< a larger ellipse is clipped, never refused
    bool subpixel = true;
    double sigma_px = 1.0;          ///< of a match without sub-pixel alignment
    double sigma_floor_px = 0.15;   ///< of a match with it, in quadrature with the alignment's own
    double max_sigma_floor_px = 1.5;  ///< the floor follows the residuals up to here; the same as
                                      ///< sigma_floor_px: it does not
    double smoothing_px = 0.7;      ///< of every image
    double max_scale = 2.0;         ///< change of a patch's size since birth
    double max_view_angle_deg = 45.0;

    static SearchOptions from(ConfigSection section);
};

enum class InitializationMethod
{
    Undelayed,
    Delayed,
    Hybrid,
};

/** How a corner becomes a landmark, ini section [initialization]. Lengths are in the unit of the
 *  map: metres after a metric start, else the median depth of the first landmarks. */
struct MONOSLAM_SLAM_EXPORT InitializationOptions
{
    InitializationMethod method = InitializationMethod::Hybrid;
    int hybrid_min_measured = 20;    ///< fewer measured: the best corners enter undelayed
    double rho0 = 1.0;               ///< of the first landmarks [1/unit]
    double sigma_rho = 0.5;          ///< of the first landmarks [1/unit]
    double relative_sigma_rho = 0.5; ///< of later ones, relative to the map's median
    double alpha_min_deg = 3.0;
    double b_min = 0.0;              ///< least baseline [unit]
    double b_min_relative = 0.05;    ///< least baseline relative to the depth
    double angle_min_deg = 20.0;     ///< beta and gamma keep this far from 0 and 180
    int min_seen = 5;
    double max_relative_sigma = 0.3; ///< reject a landmark with a poorer depth
    double sigma_floor = 0.02;       ///< sigma_rho is at least this times rho at birth
    bool clone = true;               ///< covariance = clone | paper
    int max_clones = 8;
    int max_candidates = 25;
    double sigma_v = 0.3;            ///< first velocity [unit/s]
    double sigma_omega_radps = 0.5;  ///< first angular velocity

    static InitializationOptions from(ConfigSection section);
};

/** Re-estimation of the first seconds, ini section [start]. */
struct MONOSLAM_SLAM_EXPORT StartOptions
{
    std::vector<double> parallax_deg{0.5, 1.0, 2.0, 4.0, 8.0};  ///< medians at which it happens; empty = never
    int views = 20;                 ///< of the window, evenly spaced
    int max_frames = 200;           ///< after which the window closes
    int min_sightings = 3;          ///< of a landmark that stays
    double min_inlier_ratio = 0.6;  ///< of its pixels
    double good_inlier_ratio = 0.98;  ///< fewer explained pixels: other solutions are tried too
    double accept_inlier_ratio = 0.8;  ///< fewer still: the filter's own belief stays
    double point_sigma = 0.0005;    ///< of known points, from [metric_start] [unit]

    static StartOptions from(ConfigSection section);
};

/** What stays in the map, ini section [map]. */
struct MONOSLAM_SLAM_EXPORT MapOptions
{
    int measured_target = 50;      ///< landmarks to be measured in a frame
    int max_landmarks = 100;
    double min_found_ratio = 0.5;  ///< found / searched, after min_searched searches
    int min_searched = 5;
    bool delete_on_reject = false; ///< on_reject = delete (the first paper) | strike
    int strikes = 3;               ///< rejections within strike_frames that remove a landmark
    int strike_frames = 10;
    double convert_linearity = 0.02;  ///< inverse depth to point below this index; 0 = never
    int min_matched = 5;           ///< fewer: the frame only predicts
    double degraded_rejected_share = 0.3;  ///< of the pairs, running mean, beyond which the state
                                           ///< says degraded
    double degraded_residual_px = 0.75;    ///< the same for the noise that the residuals show
    int lost_after = 5;            ///< such frames in a row until the state says lost

    static MapOptions from(ConfigSection section);
};

enum class EngineName
{
    Ours,
    Mrpt,
};

/** All options of the pipeline: one struct a section. */
struct MONOSLAM_SLAM_EXPORT MonoSlamOptions
{
    ConstantVelocityOptions motion;
    SearchOptions search;
    DetectionOptions detection;
    InitializationOptions initialization;
    StartOptions start;
    MapOptions map;
    MetricStartOptions metricStart;
    EngineName engine = EngineName::Ours;

    /** Reads [motion] [search] [detection] [initialization] [start] [map] [metric_start] [filter].
     *  \throw std::invalid_argument naming file, section and key */
    static MonoSlamOptions from(const mrpt::config::CConfigFileBase& file,
                                const std::string& fileName);
};
}  // namespace monoslam
