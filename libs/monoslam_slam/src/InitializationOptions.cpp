// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/InitializationOptions.h"

#include "optionRanges.h"

namespace monoslam
{
InitializationOptions InitializationOptions::from(ConfigSection section)
{
    InitializationOptions o;
    o.method = section.get<InitializationMethod>("method", o.method,
                                                 {{"undelayed", InitializationMethod::Undelayed},
                                                  {"delayed", InitializationMethod::Delayed},
                                                  {"hybrid", InitializationMethod::Hybrid}});
    o.hybrid_min_measured = section.get("hybrid_min_measured", o.hybrid_min_measured, {0, 1000});
    o.rho0 = section.get("rho0", o.rho0, kAboveZero);
    o.sigma_rho = section.get("sigma_rho", o.sigma_rho, kAboveZero);
    o.relative_sigma_rho = section.get("relative_sigma_rho", o.relative_sigma_rho, kAboveZero);
    o.alpha_min_deg = section.get("alpha_min_deg", o.alpha_min_deg, {0.1, 60.0});
    o.b_min = section.get("b_min", o.b_min, kFromZero);
    o.b_min_relative = section.get("b_min_relative", o.b_min_relative, kFromZero);
    o.angle_min_deg = section.get("angle_min_deg", o.angle_min_deg, {0.0, 89.0});
    o.min_seen = section.get("min_seen", o.min_seen, {2, 1000});
    o.max_relative_sigma = section.get("max_relative_sigma", o.max_relative_sigma, kAboveZero);
    o.sigma_floor = section.get("sigma_floor", o.sigma_floor, kRatio);
    o.clone = section.get<bool>("covariance", o.clone, {{"clone", true}, {"paper", false}});
    o.max_clones = section.get("max_clones", o.max_clones, {1, 64});
    o.max_candidates = section.get("max_candidates", o.max_candidates, {1, 1000});
    o.sigma_v = section.get("sigma_v", o.sigma_v, kFromZero);
    o.sigma_omega_radps = section.get("sigma_omega_radps", o.sigma_omega_radps, kFromZero);
    section.rejectUnknownKeys();
    return o;
}
}  // namespace monoslam
