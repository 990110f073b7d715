// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "Job.h"

namespace monoslam
{
/** Asks mono-slam about the first job of every sequence, strategy and variant, \p slots at a time.
 *  Ends early when a signal comes.
 *  \throw std::invalid_argument naming the sections of the first that is refused, and why */
void checkJobs(const std::vector<Job>& jobs, const std::string& programs, std::size_t slots);
}  // namespace monoslam
