// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "monoslam_association/export.h"

namespace monoslam
{
/** Probability that y ~ N(mean, C) lies in the ellipse y' S^-1 y < gate, by Gauss-Legendre
 *  quadrature over one principal axis, to 1e-4. */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT double ellipseMass(const Eigen::Vector2d& mean,
                                                             const Eigen::Matrix2d& C,
                                                             const Eigen::Matrix2d& S, double gate);
}  // namespace monoslam
