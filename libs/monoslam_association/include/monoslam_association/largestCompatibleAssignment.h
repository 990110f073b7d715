// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_association/AssignmentProblem.h"
#include "monoslam_association/export.h"

namespace monoslam
{
/** The largest jointly compatible assignment, of least D2 among those: HOHCT for items with
 *  several candidates.
 *
 *      greatest k for which min over assignments A of k pairs of D2(A) <= limits[k],  and that A
 *
 * Exact. Least removals first: with i of the m items removed the tree over candidates is cut by the
 * limit of the final size, limits[m - i], which loses nothing because D2 never falls when a pair is
 * added; by every candidate that exceeds it, given the pairs accepted so far; and by the removals
 * that are left when items run out of candidates. JCBB's answer, which is never larger, is the
 * first incumbent and says which items are doubtful: they are decided first.
 * \param nodeCap  of either search; then the best assignment known is returned, not proved
 * \see algorithms 6.5; largestCompatibleSubset() for one candidate an item */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT AssignmentResult
largestCompatibleAssignment(const AssignmentProblem& problem, long nodeCap);
}  // namespace monoslam
