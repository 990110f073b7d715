// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "Arguments.h"
#include "monoslam_association/Associator.h"
#include "monoslam_eval/FeatureSlam.h"

namespace monoslam
{
/** Everything that the ini and the command line decide, checked. */
struct Config
{
    SimulationOptions simulation;
    FeatureSlamOptions slam;
    std::shared_ptr<const Associator> associator;
};

/** \throw std::exception naming file, section and key of what is wrong */
[[nodiscard]] Config loadConfig(const Arguments& arguments);

/** config/simulation.ini as it was when the program was built. */
[[nodiscard]] const char* defaultConfig();
}  // namespace monoslam
