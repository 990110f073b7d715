// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "Job.h"

namespace monoslam
{
/** A program and its arguments. */
using Command = std::vector<std::string>;

/** What a shell takes as this one word. */
[[nodiscard]] std::string shellWord(const std::string& word);

/** What a job runs, one after the other.
 *  \param programs  folder of mono-slam and mono-slam-eval
 *  \param output    folder of the batch */
[[nodiscard]] std::vector<Command> commandsOf(const Job& job, const std::string& programs,
                                              const std::string& output);

/** Asks mono-slam whether it would take the job. */
[[nodiscard]] Command checkOf(const Job& job, const std::string& programs,
                              const std::string& output);

/** The job as one line of shell, which also records that it ended well. */
[[nodiscard]] std::string shellLineOf(const Job& job, const std::string& programs,
                                      const std::string& output);
}  // namespace monoslam
