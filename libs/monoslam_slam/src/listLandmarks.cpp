// SPDX-License-Identifier: BSD-3-Clause
#include "listLandmarks.h"

namespace monoslam
{
std::vector<MapLandmark> listLandmarks(const Belief& belief, const LandmarkRecords& records)
{
    std::vector<MapLandmark> map;
    for (const auto& slot : belief.landmarks)
    {
        const LandmarkRecord& record = records.at(slot.id);
        map.push_back({slot.id, slot.kind, belief.x.segment(slot.offset, slot.size()),
                       belief.P.block(slot.offset, slot.offset, slot.size(), slot.size()),
                       record.matched, record.lastSeen, record.known.has_value(), record.bornFrame,
                       record.born.uv_px});
    }
    return map;
}
}  // namespace monoslam
