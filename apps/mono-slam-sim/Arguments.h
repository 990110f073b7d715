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
    std::string output;                 ///< a rawlog, or with run a folder
    std::string run;                    ///< rawlog to run the strategy on, instead of writing one
    std::vector<std::string> settings;  ///< "section.key=value"
    std::string defaultConfigFile;      ///< to be written, then nothing else is done
    unsigned seed = 1;
    bool force = false;
};

/** Ends the program on --help, --version and on a wrong command line. */
[[nodiscard]] Arguments parseArguments(int argc, char** argv);
}  // namespace monoslam
