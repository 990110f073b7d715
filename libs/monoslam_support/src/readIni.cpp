// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_support/readIni.h"

#include <mrpt/config/CConfigFileMemory.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace monoslam
{
namespace fs = std::filesystem;
using mrpt::config::CConfigFileMemory;

namespace
{
std::string readText(const std::string& fileName)
{
    std::ifstream stream(fileName);
    if (!fs::is_regular_file(fileName) || !stream)
        throw std::runtime_error(fileName + ": no such configuration file");
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/** "a.b.key=value" is key "key" of section "a.b". */
void apply(const std::string& setting, CConfigFileMemory& file)
{
    const auto equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    const auto dot = name.rfind('.');
    if (equals == std::string::npos || dot == std::string::npos || dot == 0 ||
        dot + 1 == name.size())
        throw std::invalid_argument("--set " + setting + ": expected section.key=value");
    file.write(name.substr(0, dot), name.substr(dot + 1), setting.substr(equals + 1));
}
}  // namespace

void readIni(const std::string& fileName, const std::vector<std::string>& settings,
             CConfigFileMemory& ini)
{
    ini.setContent(readText(fileName));
    applySettings(settings, ini);
}

void applySettings(const std::vector<std::string>& settings, CConfigFileMemory& ini)
{
    for (const std::string& setting : settings) apply(setting, ini);
}

void rejectUnknownSections(const CConfigFileMemory& ini, const std::set<std::string>& known,
                           const std::string& fileName)
{
    std::vector<std::string> present;
    ini.getAllSections(present);
    const auto unknown =
        std::find_if(present.begin(), present.end(),
                     [&](const auto& section) { return known.count(section) == 0; });
    if (unknown == present.end()) return;
    std::string message = fileName + ": unknown section [" + *unknown + "]; known:";
    for (const auto& name : known) message += " " + name;
    throw std::invalid_argument(message);
}
}  // namespace monoslam
