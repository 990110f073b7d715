// SPDX-License-Identifier: BSD-3-Clause
#include "iteratedUpdate.h"

#include <utility>

#include "ConditionalPrediction.h"
#include "relinearize.h"

namespace monoslam
{
namespace
{
/** A prediction of the prior, the pixels on its rows, and the update that they give. */
struct Linearization
{
    const Prediction* prediction;
    std::vector<PixelMeasurement> pixels;
    PendingUpdate update;
};
}  // namespace

Belief iteratedUpdate(const LinearizedPrior& from, const std::vector<PixelMeasurement>& pixels,
                      const FrameView& view, int maxIterations, int& faults)
{
    Prediction latest;  // that of `now` after the first
    Linearization now{&from.prediction, pixels,
                      view.engine.correct(from.prior, from.prediction, pixels, &faults)};
    const int made = from.at.size() > 0 ? 2 : 1;
    for (int n = made; n < maxIterations; ++n)
    {
        if (linearEnough(*now.prediction, now.pixels, from.prior, now.update.x, view)) break;
        Prediction again = predictAt(view, from.prior, now.update.x);
        auto moved = onRowsOf(again, *now.prediction, now.pixels);
        if (moved.size() < pixels.size()) break;  // a landmark left the image
        latest = std::move(again);
        now = {&latest, std::move(moved), {}};
        now.update = view.engine.correct(from.prior, latest, now.pixels, &faults);
    }
    return now.update.finish(std::move(from.prior));
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
