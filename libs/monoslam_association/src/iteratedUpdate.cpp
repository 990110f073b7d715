// SPDX-License-Identifier: BSD-3-Clause
#include "iteratedUpdate.h"

#include "ConditionalPrediction.h"
#include "relinearize.h"

namespace monoslam
{
namespace
{
/** Movement in the image, from where the projection was linearised to the posterior, below which
 *  its bend does not matter [px]: a turn by c pixels bends it by about c^2 / 1000. */
constexpr double kLinearEnough_px = 5.0;
}  // namespace

Belief iteratedUpdate(const LinearizedPrior& from, const std::vector<PixelMeasurement>& pixels,
                      const FrameView& view, int maxIterations, int& faults)
{
    Belief posterior = view.engine.update(from.prior, from.prediction, pixels, &faults);
    Eigen::VectorXd linearizedAt = from.at.size() > 0 ? from.at : from.prior.x;
    for (int iteration = 2; iteration < maxIterations; ++iteration)
    {
        const Eigen::VectorXd step = posterior.x - linearizedAt;
        if (largestShift_px(from.prediction, pixels, step) < kLinearEnough_px) break;
        const Prediction again = predictAt(view, from.prior, posterior.x);
        const auto moved = onRowsOf(again, from.prediction, pixels);
        if (moved.size() < pixels.size()) break;  // a landmark left the image: keep what we have
        linearizedAt = posterior.x;
        posterior = view.engine.update(from.prior, again, moved, &faults);
    }
    return posterior;
}

bool updatable(const Prediction& prediction, std::vector<PixelMeasurement> pixels, double& d2)
{
    for (const double inflation : {1.0, 1.1})
    {
        for (PixelMeasurement& pixel : pixels) pixel.R *= inflation;
        const ConditionalPrediction accepted(prediction, pixels);
        if (!accepted.valid()) continue;
        d2 = accepted.d2();
        return true;
    }
    return false;
}
}  // namespace monoslam
