// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "matchActively.h"

namespace monoslam
{
/** Searches frame.rows in their gates given the pixels already accepted, takes the nearest candidate
 *  of each and appends it to \p pixels. */
void matchRest(const MatchingFrame& frame, const ClutterOptions& clutter,
               std::vector<PixelMeasurement>& pixels);
}  // namespace monoslam
