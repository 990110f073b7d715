// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace monoslam
{
/** What the command line says; empty where it says nothing. */
struct Arguments
{
    std::string configFile;
    std::string rawlog;
    std::string output;
    std::vector<std::string> settings;  ///< "section.key=value"
    unsigned seed = 1;
    bool force = false;
};

/** Ends the program on --help, --version and on a wrong command line. */
[[nodiscard]] Arguments parseArguments(int argc, char** argv);
}  // namespace monoslam
