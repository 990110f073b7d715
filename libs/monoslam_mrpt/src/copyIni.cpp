// SPDX-License-Identifier: BSD-3-Clause
#include "copyIni.h"

#include <string>
#include <vector>

namespace monoslam
{
using mrpt::config::CConfigFileBase;
using mrpt::config::CConfigFileMemory;

CConfigFileMemory copyOf(const CConfigFileBase& ini)
{
    CConfigFileMemory copy;
    std::vector<std::string> sections, keys;
    ini.getAllSections(sections);
    for (const auto& section : sections)
    {
        ini.getAllKeys(section, keys);
        for (const auto& key : keys) copy.write(section, key, ini.read_string(section, key, ""));
    }
    return copy;
}
}  // namespace monoslam
