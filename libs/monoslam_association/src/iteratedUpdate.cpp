// SPDX-License-Identifier: BSD-3-Clause
#include "iteratedUpdate.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ConditionalPrediction.h"
#include "relinearize.h"

namespace monoslam
{
namespace
{
/** Error of the linear projection at the posterior, in standard deviations of the pixel's noise, below
 *  which it does not matter. */
constexpr double kLinearEnough_sigmas = 3.0;

/** A prediction of the prior, the pixels on its rows, and the posterior that they give. */
struct Linearization
{
    const Prediction* prediction;
    std::vector<PixelMeasurement> pixels;
    Belief posterior;
};

/** How far the projection is from its linearisation at the posterior, for the worst pixel: the image
 *  bends with a turn, and a parallax is the product of two unknowns, movement and depth. */
double error_sigmas(const Linearization& linearized, const Belief& prior, const FrameView& view)
{
    const Eigen::VectorXd& x = linearized.posterior.x;
    const Eigen::VectorXd step = x - prior.x;
    double worst = 0.0;
    for (const PixelMeasurement& pixel : linearized.pixels)
    {
        const auto& row = linearized.prediction->rows[static_cast<std::size_t>(pixel.row)];
        const auto slot = static_cast<std::size_t>(prior.find(row.id));
        const auto seen = view.linearize(x, prior.landmarks[slot]);
        if (!seen) continue;
        const Eigen::Vector2d e = seen->h - row.h - row.H_v * step.head<camera_state::kSize>() -
                                  row.H_y.leftCols(row.size) * step.segment(row.offset, row.size);
        worst = std::max(worst, e.dot(pixel.R.inverse() * e));
    }
    return std::sqrt(worst);
}
}  // namespace

Belief iteratedUpdate(const LinearizedPrior& from, const std::vector<PixelMeasurement>& pixels,
                      const FrameView& view, int maxIterations, int& faults)
{
    Prediction latest;  // that of `now` after the first
    Linearization now{&from.prediction, pixels,
                      view.engine.update(from.prior, from.prediction, pixels, &faults)};
    const int made = from.at.size() > 0 ? 2 : 1;
    for (int n = made; n < maxIterations; ++n)
    {
        if (error_sigmas(now, from.prior, view) < kLinearEnough_sigmas) break;
        Prediction again = predictAt(view, from.prior, now.posterior.x);
        auto moved = onRowsOf(again, *now.prediction, now.pixels);
        if (moved.size() < pixels.size()) break;  // a landmark left the image
        latest = std::move(again);
        now = {&latest, std::move(moved), {}};
        now.posterior = view.engine.update(from.prior, latest, now.pixels, &faults);
    }
    return std::move(now.posterior);
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
