// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Arguments.h"
#include "Strategies.h"

namespace monoslam
{
/** Prints a table of every file: a line a strategy.
 *  \throw std::exception naming the file that cannot be read or solved */
void solveFiles(const Arguments& arguments, const Strategies& strategies);
}  // namespace monoslam
