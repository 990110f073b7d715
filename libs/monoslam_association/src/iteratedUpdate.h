// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "monoslam_association/Associator.h"

namespace monoslam
{
/** A prediction of a prior and where it is linearised. */
struct LinearizedPrior
{
    Belief& prior;  ///< consumed: the posterior is made of it
    const Prediction& prediction;
    Eigen::VectorXd at;  ///< empty: the prior's mean
};

/** EKF update, iterated until the projection agrees with its linearisation at the posterior to within
 *  the pixels' noise, at most \p maxIterations linearisations in all. The
 *  covariance is computed once, of the last of them.
 *  \throw std::runtime_error if S stays indefinite */
[[nodiscard]] Belief iteratedUpdate(const LinearizedPrior& from,
                                    const std::vector<PixelMeasurement>& pixels,
                                    const FrameView& view, int maxIterations, int& faults);

/** Whether an update can factorise S, after the one inflation that it tries.
 *  \param d2  joint nu' S^-1 nu, if it can */
[[nodiscard]] bool updatable(const Prediction& prediction, std::vector<PixelMeasurement> pixels,
                             double& d2);
}  // namespace monoslam
