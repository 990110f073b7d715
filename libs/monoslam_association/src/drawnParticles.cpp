// SPDX-License-Identifier: BSD-3-Clause
#include "drawnParticles.h"

#include <algorithm>

#include "monoslam_association/fateCounts.h"

namespace monoslam
{
namespace
{
constexpr double kSame_px = 1.0;  ///< apart: the same pixel
constexpr long kFewest = 5;       ///< same pixels that are no chance

bool heavier(const DrawnParticle& a, const DrawnParticle& b)
{
    return a.logWeight > b.logWeight;
}

/** Whether most of the first one's pixels, and not just a few, are the second one's too. Both are
 *  sorted by landmark. */
bool agree(const std::vector<Association>& first, const std::vector<Association>& second)
{
    long matched = 0, same = 0;
    auto other = second.begin();
    for (const Association& one : first)
    {
        if (one.fate != Fate::Matched) continue;
        ++matched;
        other = std::find_if(other, second.end(), [&](const auto& a) { return a.id >= one.id; });
        same += other != second.end() && other->id == one.id && other->fate == Fate::Matched &&
                        (other->z - one.z).norm() < kSame_px
                    ? 1
                    : 0;
    }
    return same >= kFewest && 2 * same > matched;
}
}  // namespace

bool isTrusted(const std::vector<DrawnParticle>& drawn)
{
    const DrawnParticle& best = *std::min_element(drawn.begin(), drawn.end(), heavier);
    const std::vector<Association>& reading = best.outcome.associations;
    if (explainsFrame(countFates(reading))) return true;
    return std::any_of(drawn.begin(), drawn.end(),
                       [&](const DrawnParticle& one)
                       { return &one != &best && agree(reading, one.outcome.associations); });
}

std::vector<DrawnParticle> heaviestOf(std::vector<DrawnParticle> drawn, std::size_t count)
{
    if (drawn.size() <= count) return drawn;
    std::stable_sort(drawn.begin(), drawn.end(), heavier);
    drawn.resize(count);
    std::stable_sort(drawn.begin(), drawn.end(),
                     [](const DrawnParticle& a, const DrawnParticle& b)
                     { return a.origin < b.origin; });
    return drawn;
}
}  // namespace monoslam
