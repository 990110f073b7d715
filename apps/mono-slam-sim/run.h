// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Config.h"

namespace monoslam
{
/** The whole program. \throw std::exception with one line for people */
void run(const Arguments& arguments);

/** Simulates and writes arguments.output and its truth. */
void writeSimulation(const Arguments& arguments, const Config& config);

/** Runs the strategy on arguments.run and writes the folder arguments.output. */
void runStrategy(const Arguments& arguments, const Config& config);
}  // namespace monoslam
