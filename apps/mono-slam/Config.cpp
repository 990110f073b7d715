// SPDX-License-Identifier: BSD-3-Clause
#include "Config.h"

#include <filesystem>
#include <set>
#include <stdexcept>

#include "monoslam_association/chosenAssociator.h"
#include "monoslam_support/ConfigSection.h"
#include "monoslam_support/readIni.h"

namespace monoslam
{
namespace fs = std::filesystem;
using mrpt::config::CConfigFileMemory;

namespace
{
std::set<std::string> knownSections()
{
    std::set<std::string> known = associationSections();
    std::vector<std::string> shipped;
    CConfigFileMemory(std::string(defaultConfig())).getAllSections(shipped);
    known.insert(shipped.begin(), shipped.end());
    return known;
}

void completeRawlogPath(Config& config, const Arguments& arguments)
{
    std::string& file = config.rawlog.file;
    if (!arguments.rawlog.empty())
        file = arguments.rawlog;
    else if (file.empty())
        throw std::invalid_argument(config.fileName + ": [rawlog] file: no rawlog is given");
    else
        file = (fs::path(config.fileName).parent_path() / file).string();
}

void copyValues(const CConfigFileMemory& file, Config& config)
{
    std::vector<std::string> sections, keys;
    file.getAllSections(sections);
    for (const auto& section : sections)
    {
        file.getAllKeys(section, keys);
        for (const auto& key : keys)
            config.values[section][key] = file.read_string(section, key, "");
    }
}
}  // namespace

OutputOptions OutputOptions::from(ConfigSection section)
{
    OutputOptions o;
    o.directory = section.get("directory", o.directory);
    o.pictures = section.get("pictures", o.pictures);
    o.picture_every_nth = section.get("picture_every_nth", o.picture_every_nth, {1, 1e6});
    o.associations = section.get("associations", o.associations);
    section.rejectUnknownKeys();
    return o;
}

Config loadConfig(const Arguments& arguments)
{
    Config config;
    config.fileName = arguments.configFile;
    CConfigFileMemory file;
    readIni(config.fileName, arguments.settings, file);
    rejectUnknownSections(file, knownSections(), config.fileName);
    const auto section = [&](const char* name)
    { return ConfigSection(file, name, config.fileName); };
    config.rawlog = RawlogOptions::from(section("rawlog"));
    config.camera = CameraOptions::from(section("camera"));
    config.output = OutputOptions::from(section("output"));
    config.slam = MonoSlamOptions::from(file, config.fileName);
    config.slam.estimateReadout = config.camera.estimateReadout;
    config.associator = chosenAssociator(file, config.fileName);
    if (config.slam.engine == EngineName::Mrpt && !config.associator->updatesByEngine())
        throw std::invalid_argument(
            config.fileName + ": [filter] engine = mrpt: not with [association] strategy = " +
            section("association").get("strategy", "") + ", which corrects pixel by pixel itself");
    completeRawlogPath(config, arguments);
    if (!arguments.output.empty()) config.output.directory = arguments.output;
    config.output.pictures = config.output.pictures || arguments.pictures;
    copyValues(file, config);
    return config;
}
}  // namespace monoslam
