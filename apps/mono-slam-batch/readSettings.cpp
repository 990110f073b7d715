// SPDX-License-Identifier: BSD-3-Clause
#include "readSettings.h"

#include <map>

namespace monoslam
{
std::vector<std::string> readSettings(ConfigSection& section)
{
    const std::map<std::string, std::string> ours{
        {"association.strategy", "given by [batch] strategies"},
        {"rawlog.file", "given by the key rawlog of a sequence"},
        {"output.directory", "given by [batch] output"}};
    std::vector<std::string> settings;
    for (const std::string& key : section.keys())
    {
        if (key.find('.') == std::string::npos) continue;
        const auto found = ours.find(key);
        if (found != ours.end()) section.fail(key, found->second);
        settings.push_back(key + "=" + section.get(key, ""));
    }
    return settings;
}
}  // namespace monoslam
