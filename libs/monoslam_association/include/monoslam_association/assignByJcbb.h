// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_association/AssignmentProblem.h"
#include "monoslam_association/export.h"

namespace monoslam
{
/** Joint compatibility branch and bound, of measurements of any dimension: jointBranchAndBound() on
 *  items that compete for what they use.
 *
 * Depth first over the items, each candidate, nearest first, and then none. A branch is cut when
 * its D2 exceeds the limit of its own size, or when it cannot have more pairs than the best
 * assignment, counting each undecided item that has a candidate once, or as many at a lesser D2.
 * The limit of a prefix is lower than that of the assignment: the answer depends on the order of
 * the items and can be smaller than largestCompatibleAssignment().
 * \param nodeCap  then the best assignment so far is returned, not proved
 * \see Neira, Tardos, "Data association in stochastic mapping using the joint compatibility test",
 *      2001 */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT AssignmentResult
assignByJcbb(const AssignmentProblem& problem, long nodeCap);
}  // namespace monoslam
