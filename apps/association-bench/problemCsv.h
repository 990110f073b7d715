// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monoslam_eval/solveProblem.h"

namespace monoslam
{
/** Names of the columns of problemLine(). */
[[nodiscard]] std::string problemHead();

/** What one strategy made of one recorded problem, as a line of CSV: n is pairs, r is rejected. */
[[nodiscard]] std::string problemLine(const std::string& file, long frame,
                                      const std::string& strategy, const Solution& solution);
}  // namespace monoslam
