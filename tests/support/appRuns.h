// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <regex>
#include <stdexcept>
#include <string>

#include "TemporaryFolder.h"
#include "datasets.h"
#include "runProgram.h"

namespace monoslam
{
inline std::string quoted(const std::string& text)
{
    return "'" + text + "'";
}

inline std::string shipped(const std::string& name)
{
    return (sourceFolder() / name).string();
}

/** One number of a JSON file of ours. */
inline double figure(const std::string& file, const std::string& key)
{
    const std::string text = readText(file);
    std::smatch found;
    const std::regex pattern("\"" + key + "\": *([-+.eE0-9]+)");
    if (!std::regex_search(text, found, pattern)) throw std::runtime_error(file + ": no " + key);
    return std::stod(found[1]);
}

/** Runs mono-slam and fails the test with its output if it does not end well. */
inline void run(const std::string& arguments, const std::string& output,
                const std::string& prefix = {})
{
    const auto result = runProgram("mono-slam", arguments + " --output " + quoted(output), prefix);
    ASSERT_EQ(result.status, 0) << result.output;
}

inline void evaluate(const std::string& truth, const std::string& output)
{
    const auto result =
        runProgram("mono-slam-eval", "--groundtruth " + quoted(truth) + " " + quoted(output) +
                                         " --json " + quoted(output + "/figures.json"));
    ASSERT_EQ(result.status, 0) << result.output;
}

/** The shipped sequence with its metric target. */
inline const std::string kDesk = quoted(shipped("config/desk.ini"));
}  // namespace monoslam
