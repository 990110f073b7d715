// SPDX-License-Identifier: BSD-3-Clause
#include "postFitResiduals.h"

#include <cmath>

#include "monoslam_models/projectLandmark.h"

namespace monoslam
{
namespace
{
constexpr int kSettled = 5;  ///< matches after which a landmark's residual tells of noise

}  // namespace

std::optional<double> squaredResidual(const Belief& belief, const Camera& camera,
                                      const Association& association)
{
    const Eigen::Index index = belief.find(association.id);
    if (index < 0) return std::nullopt;
    const auto& slot = belief.landmarks[static_cast<std::size_t>(index)];
    const auto pixel = projectPixel(camera, belief.camera(), slot.kind,
                                    belief.x.segment(slot.offset, slot.size()));
    if (!pixel) return std::nullopt;
    return (*pixel - association.z).squaredNorm();
}

std::vector<double> settledResiduals(const Belief& belief, const Camera& camera,
                                     const std::vector<Association>& associations,
                                     const LandmarkRecords& records)
{
    std::vector<double> squares;
    for (const auto& association : associations)
    {
        const bool found = association.fate == Fate::Matched || association.fate == Fate::Rejected;
        const auto record = records.find(association.id);
        if (!found || record == records.end() || record->second.matched < kSettled) continue;
        const auto square = squaredResidual(belief, camera, association);
        if (square) squares.push_back(*square);
    }
    return squares;
}

double residualRms_px(const Belief& belief, const Camera& camera,
                      const std::vector<Association>& associations)
{
    double sum = 0.0;
    int count = 0;
    for (const auto& association : associations)
    {
        if (association.fate != Fate::Matched) continue;
        const auto square = squaredResidual(belief, camera, association);
        if (!square) continue;
        sum += *square;
        ++count;
    }
    return count > 0 ? std::sqrt(sum / (2.0 * count)) : 0.0;
}
}  // namespace monoslam
