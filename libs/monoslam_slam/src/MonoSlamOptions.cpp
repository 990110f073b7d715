// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/MonoSlamOptions.h"

#include "optionRanges.h"

namespace monoslam
{
namespace
{
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

MonoSlamOptions MonoSlamOptions::from(const mrpt::config::CConfigFileBase& file,
                                      const std::string& fileName)
{
    const auto section = [&](const char* name) { return ConfigSection(file, name, fileName); };
    MonoSlamOptions o;
    o.motion = ConstantVelocityOptions::from(section("motion"));
    o.search = SearchOptions::from(section("search"));
    o.detection = detectionFrom(section("detection"));
    o.detection.half_px = o.search.patch_px / 2;
    o.detection.border_px = o.detection.half_px + 4.0;
    o.initialization = InitializationOptions::from(section("initialization"));
    o.start = StartOptions::from(section("start"));
    o.map = MapOptions::from(section("map"));
    o.metricStart = MetricStartOptions::from(section("metric_start"));
    o.start.point_sigma = o.metricStart.point_sigma_m;
    o.engine = engineFrom(section("filter"));
    return o;
}
}  // namespace monoslam
