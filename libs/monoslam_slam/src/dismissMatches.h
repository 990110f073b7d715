// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_association/Associator.h"
#include "monoslam_slam/MapOptions.h"

namespace monoslam
{
/** Whether all matches of a frame may be chance: too few to fix a pose, or fewer than min_matched
 *  and few among those searched. The ellipses of a camera that is about to be lost are so large that
 *  something in them always looks like the landmark. */
[[nodiscard]] bool mayBeChance(const std::vector<Association>& associations,
                               const MapOptions& options);

/** The frame without its matches, which count as rejected: of all beliefs only the prediction of one
 *  remains.
 *  \param predicted  the belief before the update; \param parent  its index in the mixture */
[[nodiscard]] Correction dismissMatches(Correction correction, Belief predicted,
                                        std::size_t parent);
}  // namespace monoslam
