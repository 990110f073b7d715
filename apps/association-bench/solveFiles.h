// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "Arguments.h"
#include "Strategies.h"

namespace monoslam
{
/** Prints a table of every file, a line a strategy, unless a CSV is asked for.
 *  \return that CSV: a line a file and strategy
 *  \throw std::exception naming the file that cannot be read or solved */
[[nodiscard]] std::string solveFiles(const Arguments& arguments, const Strategies& strategies);
}  // namespace monoslam
