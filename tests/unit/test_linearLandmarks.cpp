// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/linearLandmarks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "randomBelief.h"

namespace monoslam
{
TEST(LinearLandmarks, AreThoseWhoseDepthIsKnownWell)
{
    std::mt19937 rng(8);
    const Camera camera;
    Belief belief = randomBelief(rng, camera, {6, 2, true});
    EXPECT_TRUE(linearLandmarks(belief, 0.0).empty());
    const LandmarkSlot& slot = belief.landmarks[3];
    const Vector6d y = belief.x.segment<6>(slot.offset);
    const Eigen::Index rho = slot.offset + inverse_depth::kRho;
    const double index = linearityIndex(y, std::sqrt(belief.P(rho, rho)), belief.x.head<3>());
    const auto has = [&](double limit)
    {
        const auto ids = linearLandmarks(belief, limit);
        return std::count(ids.begin(), ids.end(), slot.id) == 1;
    };
    EXPECT_TRUE(has(index * 1.001));
    EXPECT_FALSE(has(index * 0.999));
    belief.x[rho] *= -1.0;  // behind the camera
    EXPECT_FALSE(has(1e9));
    for (const LandmarkId id : linearLandmarks(belief, 1e9))
        EXPECT_EQ(belief.landmarks[static_cast<std::size_t>(belief.find(id))].kind,
                  LandmarkKind::InverseDepth);
}
}  // namespace monoslam
