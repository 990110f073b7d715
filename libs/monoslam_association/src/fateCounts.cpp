// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/fateCounts.h"

#include <algorithm>

namespace monoslam
{
FateCounts countFates(const std::vector<Association>& associations)
{
    const auto count = [&associations](Fate fate)
    {
        return std::count_if(associations.begin(), associations.end(),
                             [fate](const Association& a) { return a.fate == fate; });
    };
    return {count(Fate::NotSearched), count(Fate::NotFound), count(Fate::Rejected),
            count(Fate::Matched)};
}

bool explainsFrame(const FateCounts& counts)
{
    return 2 * counts.matched >= counts.searched();
}
}  // namespace monoslam
