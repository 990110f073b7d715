// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "monoslam_association/Associator.h"

namespace monoslam
{
[[nodiscard]] bool positiveDefinite(const Eigen::Matrix2d& A);

/** At most \p most of what a search found, best score first, without what is no measurement. */
[[nodiscard]] std::vector<Candidate> bestCandidates(std::vector<Candidate> found, int most);
}  // namespace monoslam
