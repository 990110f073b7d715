// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_slam/export.h"

namespace monoslam
{
class ConfigSection;

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
    int hybrid_min_measured = 20;     ///< fewer measured: the best corners enter undelayed
    double rho0 = 1.0;                ///< of the first landmarks [1/unit]
    double sigma_rho = 0.5;           ///< of the first landmarks [1/unit]
    double relative_sigma_rho = 0.5;  ///< of later ones, relative to the map's median
    double alpha_min_deg = 3.0;
    double b_min = 0.0;            ///< least baseline [unit]
    double b_min_relative = 0.05;  ///< least baseline relative to the depth
    double angle_min_deg = 20.0;   ///< beta and gamma keep this far from 0 and 180
    int min_seen = 5;
    double max_relative_sigma = 0.3;  ///< reject a landmark with a poorer depth
    double sigma_floor = 0.02;        ///< sigma_rho is at least this times rho at birth
    bool clone = true;                ///< covariance = clone | paper
    int max_clones = 8;
    int max_candidates = 25;
    double sigma_v = 0.3;            ///< first velocity [unit/s]
    double sigma_omega_radps = 1.0;  ///< first angular velocity

    static InitializationOptions from(ConfigSection section);
};
}  // namespace monoslam
