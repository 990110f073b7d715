// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "monoslam_filter/ekf.h"

namespace monoslam
{
/** The two steps of a Kalman filter on a Belief: ours by default, MRPT's as a baseline. */
struct FilterEngine
{
    std::function<Belief(Belief, const ConstantVelocityOptions&, double dt_s)> predict =
        [](Belief belief, const ConstantVelocityOptions& motion, double dt_s)
    { return ekfPredict(std::move(belief), motion, dt_s); };

    std::function<Belief(Belief, const Prediction&, const std::vector<PixelMeasurement>&, int*)>
        update = [](Belief prior, const Prediction& prediction,
                    const std::vector<PixelMeasurement>& pixels, int* faults)
    { return ekfUpdate(std::move(prior), prediction, pixels, faults); };
};
}  // namespace monoslam
