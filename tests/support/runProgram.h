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

/** Runs one of our programs through the shell. \param prefix  before its name, such as "timeout 1" */
inline ProgramResult runProgram(const std::string& name, const std::string& arguments,
                                const std::string& prefix = {})
{
    const std::string command =
        prefix + " '" + (programFolder() / name).string() + "' " + arguments + " 2>&1";
    ProgramResult result;
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return result;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        result.output.append(buffer.data(), count);
    const int status = pclose(pipe);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
}
}  // namespace monoslam
