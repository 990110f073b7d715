// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_association/Associator.h"

namespace monoslam
{
/** Whether the image contradicts a frame's matches: less than half of the searched landmarks were
 *  matched, and of the others most look as expected elsewhere in the ellipses that they had before
 *  any match. What is hidden, blurred or gone is not found there either.
 *
 * Strategies that shrink an ellipse by matches of the same frame look past the right pixels once one
 * of the first matches is wrong, and whatever lies in such ellipses agrees with it.
 *
 *  \param predicted  the belief before the update */
[[nodiscard]] bool isContradicted(const std::vector<Association>& associations,
                                  const Belief& predicted, const FrameView& view);
}  // namespace monoslam
