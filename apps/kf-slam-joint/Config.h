// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/config/CConfigFileMemory.h>

#include <string>
#include <vector>

#include "Arguments.h"

namespace monoslam
{
/** [MappingApplication] of kf-slam. Input files are relative to the ini, outputs to where we are. */
struct Config
{
    mrpt::config::CConfigFileMemory ini;  ///< all of it, for the filter
    std::string rawlog;
    std::string output = "OUT_KF-SLAM";
    std::string truthOfLandmarks;    ///< x y z, ..., ID in the seventh column
    std::string truthOfPath;         ///< x y z yaw pitch roll, a line a step
    std::string truthOfAssociation;  ///< time, index in the observation, landmark
    long firstEntry = 0;             ///< of the rawlog
    long saveEvery = 1;              ///< steps
    bool saveAssociations = true;
    bool saveScenes = true;
    bool saveMaps = true;
    bool inPlane = false;  ///< CRangeBearingKFSLAM2D
    unsigned seed = 1;

    /** Keys that kf-slam ignores silently, as many of MRPT's samples have them, and its live view. */
    std::vector<std::string> warnings;
};

/** \throw std::exception naming file, section and key of what is wrong */
[[nodiscard]] Config loadConfig(const Arguments& arguments);
}  // namespace monoslam
