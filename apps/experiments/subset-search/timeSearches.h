// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cell.h"

namespace monoslam
{
/** The table of times: HOHCT against factorizing and inverting S, and against JCBB. */
void timeSearches(unsigned seeds);
}  // namespace monoslam
