// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <random>

#include "monoslam_eval/export.h"
#include "monoslam_models/ConstantVelocity.h"

namespace monoslam
{
/** One true step of the filter's own process model: impulses drawn from Q, then f(x_v, dt). */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Vector13d drawMotion(const Vector13d& x_v, double dt_s,
                                                        const ConstantVelocityOptions& options,
                                                        std::mt19937& rng);

/** A camera drawn from N(x_v, P_v): the orientation error has three numbers, as T P T' says. */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Vector13d drawCamera(const Vector13d& x_v, const Matrix13d& P_v,
                                                        std::mt19937& rng);
}  // namespace monoslam
