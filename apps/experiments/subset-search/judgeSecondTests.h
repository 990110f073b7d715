// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Cell.h"

namespace monoslam
{
/** The tables of what second tests do to the largest compatible subset: all cells with wrong pairs
 *  together, then some tests kind by kind. */
void judgeSecondTests(unsigned seeds);
}  // namespace monoslam
