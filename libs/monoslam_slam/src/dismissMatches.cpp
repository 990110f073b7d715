// SPDX-License-Identifier: BSD-3-Clause
#include "dismissMatches.h"

#include "monoslam_association/fateCounts.h"

namespace monoslam
{
namespace
{
constexpr long kPoseFixing = 3;      ///< pairs
constexpr double kLeastShare = 0.3;  ///< of the searched: fewer do not come from the right map
}  // namespace

bool mayBeChance(const std::vector<Association>& associations, const MapOptions& options)
{
    const FateCounts counts = countFates(associations);
    if (counts.matched < kPoseFixing) return true;
    return counts.matched < options.min_matched &&
           static_cast<double>(counts.matched) <
               kLeastShare * static_cast<double>(counts.searched());
}

Correction dismissMatches(Correction correction, Belief predicted, std::size_t parent)
{
    correction.mixture = {{std::move(predicted), 0.0}};
    for (Association& association : correction.associations)
    {
        if (association.fate != Fate::Matched) continue;
        association.fate = Fate::Rejected;
        ++correction.counters.rejected;
    }
    correction.counters.jointD2 = 0.0;
    if (!correction.parents.empty())
    {
        correction.ofEveryBelief = {correction.associations};
        correction.parents = {parent};
    }
    return correction;
}
}  // namespace monoslam
