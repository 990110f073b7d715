// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_filter/Belief.h"
#include "monoslam_filter/export.h"

namespace monoslam
{
/** Inverse-depth landmarks before the camera whose linearityIndex() is below \p limit: as points they
 *  are as good (Civera 2008; algorithms 2.4). */
[[nodiscard]] MONOSLAM_FILTER_EXPORT std::vector<LandmarkId> linearLandmarks(const Belief& belief,
                                                                             double limit);
}  // namespace monoslam
