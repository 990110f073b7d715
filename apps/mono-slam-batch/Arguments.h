// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace monoslam
{
/** What the command line says; empty where it says nothing. */
struct Arguments
{
    std::string batchFile;
    std::string output;
    std::string finish;  ///< folder of a job whose programs ended well; nothing else is done
    unsigned jobs = 1;   ///< processes at a time
    bool list = false;
    bool collect = false;
    bool dryRun = false;
    bool retryFailed = false;
    bool skipChecks = false;
    bool force = false;
};

/** Ends the program on --help, --version and on a wrong command line.
 *  \throw std::invalid_argument where options contradict each other */
[[nodiscard]] Arguments parseArguments(int argc, char** argv);
}  // namespace monoslam
