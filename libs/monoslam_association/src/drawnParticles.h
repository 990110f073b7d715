// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "monoslam_association/measureOneByOne.h"

/** What MHDA's particles drew in a frame, before some of them go on. */
namespace monoslam
{
/** A particle after the frame: what it found, and which of the predicted ones it was. */
struct DrawnParticle
{
    SequentialOutcome outcome;
    std::size_t origin = 0;
    double logWeight = 0.0;
};

/** Whether the heaviest explains the frame, or another one came to the same reading of it: where
 *  much is hidden or blurred, few matches are all there are. \param drawn  at least one */
[[nodiscard]] bool isTrusted(const std::vector<DrawnParticle>& drawn);

/** The count heaviest, in the order of their origins; all, as they are, if there are no more. */
[[nodiscard]] std::vector<DrawnParticle> heaviestOf(std::vector<DrawnParticle> drawn,
                                                    std::size_t count);
}  // namespace monoslam
