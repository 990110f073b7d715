// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_filter/Belief.h"

namespace monoslam
{
/** Grows x and P by \p extra rows, uncorrelated and zero. */
void grow(Belief& belief, Eigen::Index extra);

/** Lays the state out anew after slots were taken from the lists. */
void compact(Belief& belief);
}  // namespace monoslam
