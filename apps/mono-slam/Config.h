// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/config/CConfigFileMemory.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "Arguments.h"
#include "monoslam_association/Associator.h"
#include "monoslam_mrpt/RawlogReader.h"
#include "monoslam_slam/MonoSlamOptions.h"

namespace monoslam
{
/** Options of ini section [output]. */
struct OutputOptions
{
    std::string directory = "mono-slam-out";
    bool pictures = false;
    int picture_every_nth = 1;
    bool associations = false;

    static OutputOptions from(ConfigSection section);
};

/** Everything that the ini and the command line decide, checked. */
struct Config
{
    std::string fileName;
    std::map<std::string, std::map<std::string, std::string>> values;  ///< section, key, value
    RawlogOptions rawlog;
    CameraOptions camera;
    OutputOptions output;
    MonoSlamOptions slam;
    std::unique_ptr<Associator> associator;
};

/** \throw std::exception naming file, section and key of what is wrong */
[[nodiscard]] Config loadConfig(const Arguments& arguments);

/** config/default.ini as it was when the program was built. */
[[nodiscard]] const char* defaultConfig();
}  // namespace monoslam
