// SPDX-License-Identifier: BSD-3-Clause
#include "Config.h"

#include <mrpt/config/CConfigFileMemory.h>

#include "monoslam_association/chosenAssociator.h"
#include "monoslam_mrpt/cameraFrom.h"
#include "monoslam_support/ConfigSection.h"
#include "monoslam_support/readIni.h"

namespace monoslam
{
namespace
{
CameraParameters readCamera(ConfigSection section)
{
    const CameraOptions camera = CameraOptions::from(section);
    if (!camera.calibration) section.fail("source", "a simulation needs source = ini");
    if (camera.readout_s != 0.0 || camera.estimateReadout)
        section.fail("readout_s", "the simulated shutter is global");
    return *camera.calibration;
}
}  // namespace

Config loadConfig(const Arguments& arguments)
{
    const std::string& fileName = arguments.configFile;
    mrpt::config::CConfigFileMemory file;
    readIni(fileName, arguments.settings, file);
    std::set<std::string> known = associationSections();
    known.insert(
        {"camera", "simulation", "path", "target", "wrong_matches", "moving", "motion", "slam"});
    rejectUnknownSections(file, known, fileName);
    Config config;
    config.simulation = SimulationOptions::from(file, fileName);
    config.simulation.world.camera = readCamera({file, "camera", fileName});
    config.slam = FeatureSlamOptions::from(file, fileName);
    config.associator = chosenAssociator(file, fileName);
    return config;
}
}  // namespace monoslam
