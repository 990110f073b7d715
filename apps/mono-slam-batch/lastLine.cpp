// SPDX-License-Identifier: BSD-3-Clause
#include "lastLine.h"

#include <fstream>

namespace monoslam
{
std::string lastLineOf(const std::string& path)
{
    std::ifstream file(path);
    std::string last;
    for (std::string line; std::getline(file, line);)
    {
        const auto end = line.find_last_not_of(" \t\r");
        if (end == std::string::npos) continue;
        line.resize(end + 1);
        last = line.substr(line.rfind('\r') + 1);  // what a progress bar has overwritten
    }
    return last;
}
}  // namespace monoslam
