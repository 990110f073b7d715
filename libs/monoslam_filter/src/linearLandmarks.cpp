// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/linearLandmarks.h"

#include <algorithm>
#include <cmath>

#include "monoslam_models/InverseDepth.h"

namespace monoslam
{
std::vector<LandmarkId> linearLandmarks(const Belief& belief, double limit)
{
    std::vector<LandmarkId> linear;
    for (const LandmarkSlot& slot : belief.landmarks)
    {
        if (slot.kind != LandmarkKind::InverseDepth) continue;
        const Vector6d y = belief.x.segment<inverse_depth::kSize>(slot.offset);
        const Eigen::Index rho = slot.offset + inverse_depth::kRho;
        const double sigma_rho = std::sqrt(std::max(belief.P(rho, rho), 0.0));
        if (y[inverse_depth::kRho] > 0.0 &&
            linearityIndex(y, sigma_rho, belief.x.head<3>()) < limit)
            linear.push_back(slot.id);
    }
    return linear;
}
}  // namespace monoslam
