// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_association/export.h"
#include "monoslam_filter/predictMeasurements.h"

namespace monoslam
{
/** At most \p count of the rows, one after the other the one that tells most about the camera pose
 *  given those chosen before (conditional mutual information); O(count^2 m) beside O(count m).
 *  \see Handa, Chli, Strasdat, Davison, "Scalable active matching", CVPR 2010 */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT std::vector<Eigen::Index> chooseSubset(
    const Belief& belief, const Prediction& prediction, std::vector<Eigen::Index> rows,
    std::size_t count);
}  // namespace monoslam
