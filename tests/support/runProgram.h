// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

#include "datasets.h"

namespace monoslam
{
struct ProgramResult
{
    int status = -1;
    std::string output;  ///< stdout and stderr
};

/** Runs a command line through the shell. */
inline ProgramResult runShell(const std::string& command)
{
    ProgramResult result;
    FILE* pipe = popen(("{ " + command + "; } 2>&1").c_str(), "r");
    if (pipe == nullptr) return result;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        result.output.append(buffer.data(), count);
    const int status = pclose(pipe);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
}

inline std::string quotedProgram(const std::string& name)
{
    return "'" + (programFolder() / name).string() + "'";
}

/** Runs one of our programs. \param prefix  before its name, such as "taskset -c 0" */
inline ProgramResult runProgram(const std::string& name, const std::string& arguments,
                                const std::string& prefix = {})
{
    return runShell(prefix + " " + quotedProgram(name) + " " + arguments);
}
}  // namespace monoslam
