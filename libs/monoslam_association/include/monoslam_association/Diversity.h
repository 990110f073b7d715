// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_association/export.h"
#include "monoslam_filter/Belief.h"

namespace monoslam
{
/** How much the beliefs of a mixture differ. */
struct Diversity
{
    long beliefs = 1;
    double effective = 1.0;       ///< 1 / sum of squared weights
    double distance = 0.0;        ///< largest between two camera positions [m, or unit]
    double angle_rad = 0.0;       ///< largest between two camera orientations
    long ancestorAge_frames = 0;  ///< frames since all of them were one belief
};

[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT Diversity diversityOf(const Mixture& mixture);
}  // namespace monoslam
