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
    std::string robotPath;
    std::string defaultConfigFile;  ///< to be written, then nothing else is done
    std::string dumpFolder;         ///< for association problems
    std::string dumpFrames;         ///< which of them: "7,100-120"; empty = all
    bool listStrategies = false;    ///< nothing else is done
    unsigned seed = 1;
    bool force = false;
    bool dryRun = false;
    bool pictures = false;
};

/** Ends the program on --help, --version and on a wrong command line. */
[[nodiscard]] Arguments parseArguments(int argc, char** argv);
}  // namespace monoslam
