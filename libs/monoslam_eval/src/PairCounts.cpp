// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/PairCounts.h"

#include <algorithm>
#include <limits>
#include <map>

namespace monoslam
{
namespace
{
double share(long part, long all)
{
    return all > 0 ? static_cast<double>(part) / static_cast<double>(all)
                   : std::numeric_limits<double>::quiet_NaN();
}
}  // namespace

void PairCounts::add(const std::vector<Association>& associations, const PixelFrame& frame)
{
    std::map<LandmarkId, Eigen::Vector2d> images;
    for (const PixelFeature& feature : frame.features)
        if (feature.truth >= 0) images[feature.truth] = feature.z;
    for (const Association& pair : associations)
    {
        const auto own = images.find(pair.id);
        available += own != images.end() ? 1 : 0;
        if (pair.fate != Fate::Matched) continue;
        // A candidate is handed on as it is, so that its pixel names it.
        const bool isOwn = own != images.end() && pair.z == own->second;
        ++(isOwn ? right : wrong);
    }
}

double PairCounts::precision() const
{
    return share(right, right + wrong);
}

double PairCounts::recall() const
{
    return share(right, available);
}
}  // namespace monoslam
