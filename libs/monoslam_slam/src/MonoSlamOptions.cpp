// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/MonoSlamOptions.h"

#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
namespace
{
constexpr Range kAboveZero{1e-12, 1e12};
constexpr Range kFromZero{0.0, 1e12};
constexpr Range kRatio{0.0, 1.0};

DetectionOptions detectionFrom(ConfigSection section)
{
    DetectionOptions o;
    o.gridColumns = section.get("grid_columns", o.gridColumns, {1, 64});
    o.gridRows = section.get("grid_rows", o.gridRows, {1, 64});
    o.maxPerCell = section.get("max_per_cell", o.maxPerCell, {1, 100});
    o.minDistance_px = section.get("min_distance_px", o.minDistance_px, {1.0, 1000.0});
    o.quality = section.get("quality", o.quality, kRatio);
    o.minResponse = section.get("min_response", o.minResponse, kFromZero);
    o.maxSelfSimilarity = section.get("max_self_similarity", o.maxSelfSimilarity, kRatio);
    o.maxCells = section.get("max_cells", o.maxCells, {1, 10000});
    o.similarityRadius_px = section.get("similarity_radius_px", o.similarityRadius_px, {4.0, 60.0});
    section.rejectUnknownKeys();
    return o;
}

EngineName engineFrom(ConfigSection section)
{
    const auto engine = section.get<EngineName>(
        "engine", EngineName::Ours, {{"ours", EngineName::Ours}, {"mrpt", EngineName::Mrpt}});
    section.rejectUnknownKeys();
    return engine;
}
}  // namespace

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
    o.max_sigma_floor_px =
        section.get("max_sigma_floor_px", o.max_sigma_floor_px, {0.0, 100.0});
    o.smoothing_px = section.get("smoothing_px", o.smoothing_px, {0.0, 3.0});
    o.max_scale = section.get("max_scale", o.max_scale, {1.05, 10.0});
    o.max_view_angle_deg = section.get("max_view_angle_deg", o.max_view_angle_deg, {1.0, 85.0});
    section.rejectUnknownKeys();
    return o;
}

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
    section.rejectUnknownKeys();
    return o;
}

MonoSlamOptions MonoSlamOptions::from(const mrpt::config::CConfigFileBase& file,
                                      const std::string& fileName)
{
    const auto section = [&](const char* name) { return ConfigSection(file, name, fileName); };
    MonoSlamOptions o;
    o.motion = ConstantVelocityOptions::from(section("motion"));
    o.search = SearchOptions::from(section("search"));
    o.detection = detectionFrom(section("detection"));
    o.detection.half_px = o.search.patch_px / 2;
    o.detection.border_px = o.search.patch_px / 2 + 4.0;
    o.initialization = InitializationOptions::from(section("initialization"));
    o.start = StartOptions::from(section("start"));
    o.map = MapOptions::from(section("map"));
    o.metricStart = MetricStartOptions::from(section("metric_start"));
    o.start.point_sigma = o.metricStart.point_sigma_m;
    o.engine = engineFrom(section("filter"));
    return o;
}
}  // namespace monoslam
