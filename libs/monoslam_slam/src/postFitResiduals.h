// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "LandmarkRecord.h"
#include "monoslam_association/Associator.h"
#include "monoslam_models/Camera.h"

namespace monoslam
{
/** Squared distance of a measured pixel from the landmark's projection now [px^2]; nothing if it is
 *  not in the state or cannot be projected. */
[[nodiscard]] std::optional<double> squaredResidual(const Belief& belief, const Camera& camera,
                                                    const Association& association);

/** Squared post-fit residuals [px^2] of every pair found, right or wrong, of landmarks that have
 *  settled. */
[[nodiscard]] std::vector<double> settledResiduals(const Belief& belief, const Camera& camera,
                                                   const std::vector<Association>& associations,
                                                   const LandmarkRecords& records);

/** Post-fit residual of the matched pixels, per coordinate [px]; 0 without any. */
[[nodiscard]] double residualRms_px(const Belief& belief, const Camera& camera,
                                    const std::vector<Association>& associations);
}  // namespace monoslam
