// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "monoslam_filter/ekf.h"

namespace monoslam
{
/** A correction whose mean is known and whose covariance is not computed yet. */
struct PendingUpdate
{
    Eigen::VectorXd x;
    std::function<Belief(Belief prior)>
        finish;  ///< the posterior, of the prior that it was made for
};

/** The two steps of a Kalman filter on a Belief: ours by default, MRPT's as a baseline. */
struct FilterEngine
{
    std::function<Belief(Belief, const ConstantVelocityOptions&, double dt_s)> predict =
        [](Belief belief, const ConstantVelocityOptions& motion, double dt_s)
    { return ekfPredict(std::move(belief), motion, dt_s); };

    std::function<PendingUpdate(const Belief& prior, const Prediction&,
                                const std::vector<PixelMeasurement>&, int* faults)>
        correct = [](const Belief& prior, const Prediction& prediction,
                     const std::vector<PixelMeasurement>& pixels, int* faults)
    {
        const auto correction =
            std::make_shared<const EkfCorrection>(ekfCorrection(prior, prediction, pixels, faults));
        return PendingUpdate{correction->x, [correction](Belief before)
                             { return applyCorrection(std::move(before), *correction); }};
    };

    [[nodiscard]] Belief update(Belief prior, const Prediction& prediction,
                                const std::vector<PixelMeasurement>& pixels,
                                int* faults = nullptr) const
    {
        const PendingUpdate pending = correct(prior, prediction, pixels, faults);
        return pending.finish(std::move(prior));
    }
};
}  // namespace monoslam
