// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monoslam_models/ConstantVelocity.h"
#include "monoslam_slam/InitializationOptions.h"
#include "monoslam_slam/MapOptions.h"
#include "monoslam_slam/MetricStart.h"
#include "monoslam_slam/SearchOptions.h"
#include "monoslam_slam/StartOptions.h"
#include "monoslam_slam/export.h"
#include "monoslam_vision/detectCorners.h"

namespace mrpt::config
{
class CConfigFileBase;
}

namespace monoslam
{
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
    bool estimateReadout = false;  ///< of a rolling shutter; not read here, [camera] says it

    /** Reads [motion] [search] [detection] [initialization] [start] [map] [metric_start] [filter].
     *  \throw std::invalid_argument naming file, section and key */
    static MonoSlamOptions from(const mrpt::config::CConfigFileBase& file,
                                const std::string& fileName);
};
}  // namespace monoslam
