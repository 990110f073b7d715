// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "monoslam_association/export.h"

namespace monoslam
{
/** Column of each row so that the sum of costs is least and no column is used twice: the Hungarian
 *  method with potentials, O(rows^2 columns).
 *  \param cost  finite; at least as many columns as rows
 *  \throw std::invalid_argument on fewer columns than rows
 *  \see Kuhn, "The Hungarian method for the assignment problem", 1955; Jonker, Volgenant, 1987 */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT std::vector<Eigen::Index> leastCostAssignment(
    const Eigen::MatrixXd& cost);
}  // namespace monoslam
