// SPDX-License-Identifier: BSD-3-Clause
#include "contradiction.h"

#include <algorithm>

#include "monoslam_association/fateCounts.h"
#include "monoslam_association/jointCompatibility.h"

namespace monoslam
{
namespace
{
constexpr double kHalf = 0.5;
constexpr double kGateProbability = 0.99;
constexpr std::size_t kMostAsked = 16;  ///< of the missed: enough for a share, and bounds the time

/** Every k-th of them: ids are by age, and neighbours often lie together. */
std::vector<LandmarkId> someMissed(const std::vector<Association>& associations)
{
    std::vector<LandmarkId> missed;
    for (const Association& association : associations)
        if (association.fate == Fate::NotFound) missed.push_back(association.id);
    const std::size_t step = 1 + (missed.size() - 1) / kMostAsked;
    std::vector<LandmarkId> some;
    for (std::size_t i = 0; i < missed.size(); i += step) some.push_back(missed[i]);
    return some;
}

bool isSeen(const PredictedLandmark& row, const FrameView& view)
{
    SearchRegion region;
    region.id = row.id;
    region.centre = row.h;
    region.S = row.S;
    region.gate = chi2Limit(2, kGateProbability);
    return row.h.allFinite() && !view.search(region).candidates.empty();
}
}  // namespace

bool isContradicted(const std::vector<Association>& associations, const Belief& predicted,
                    const FrameView& view)
{
    const FateCounts counts = countFates(associations);
    if (counts.notFound == 0 || explainsFrame(counts)) return false;
    const std::vector<LandmarkId> asked = someMissed(associations);
    const Prediction prior = view.predict(predicted);
    double seen = 0.0;
    for (const PredictedLandmark& row : prior.rows)
        if (std::find(asked.begin(), asked.end(), row.id) != asked.end())
            seen += isSeen(row, view) ? 1.0 : 0.0;
    const double share = seen / static_cast<double>(asked.size());
    return share > kHalf &&
           share * static_cast<double>(counts.notFound) > static_cast<double>(counts.matched);
}
}  // namespace monoslam
