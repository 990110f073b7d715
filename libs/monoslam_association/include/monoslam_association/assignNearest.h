// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_association/AssignmentProblem.h"
#include "monoslam_association/export.h"

namespace monoslam
{
/** Nearest neighbours: the item whose best candidate is best of all chooses first, and each takes
 *  the best candidate that is still free. No joint test: D2 may exceed the limit. */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT AssignmentResult
assignNearest(const AssignmentProblem& problem);
}  // namespace monoslam
