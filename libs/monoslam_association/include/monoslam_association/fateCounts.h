// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_association/Associator.h"
#include "monoslam_association/export.h"

namespace monoslam
{
/** How many of a frame's visible landmarks met each fate. */
struct FateCounts
{
    long notSearched = 0;
    long notFound = 0;
    long rejected = 0;
    long matched = 0;

    [[nodiscard]] long searched() const { return notFound + rejected + matched; }
};

[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT FateCounts
countFates(const std::vector<Association>& associations);

/** Whether at least half of the searched landmarks are matched. One wrong match that moves all later
 *  search ellipses leaves fewer; so does blur, which is no fault of the matches. */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT bool explainsFrame(const FateCounts& counts);
}  // namespace monoslam
