// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "disturbedRuns.h"

namespace monoslam
{
/** Outcomes of every duration, of seeds 1, 2, ... */
using OutcomesOfSeeds = std::vector<std::vector<Outcome>>;

/** disturbedRuns() of all seeds, the same whatever the number of threads. */
[[nodiscard]] OutcomesOfSeeds runSeeds(const Method& method, const Disturbance& disturbance,
                                       unsigned seeds, unsigned threads);
}  // namespace monoslam
