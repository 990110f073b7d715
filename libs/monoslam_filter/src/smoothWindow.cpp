// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/smoothWindow.h"

#include <algorithm>
#include <stdexcept>

#include "WindowEquations.h"

namespace monoslam
{
namespace
{
/** Levenberg-Marquardt until the cost stands still; returns the iterations used. */
int minimize(WindowEquations& equations, Window& window, const WindowOptions& options)
{
    double lambda = 1e-4;
    double cost = equations.evaluate(window, true);
    int iteration = 0;
    for (; iteration < options.maxIterations; ++iteration)
    {
        Window trial = equations.step(window, lambda);
        const double trialCost = equations.evaluate(trial, false);
        if (!(trialCost < cost))
        {
            lambda *= 10.0;
            if (lambda > 1e6) break;
            continue;
        }
        const double decrease = (cost - trialCost) / std::max(cost, 1e-12);
        window = std::move(trial);
        lambda = std::max(lambda * 0.1, 1e-9);
        cost = equations.evaluate(window, true);
        if (decrease < options.convergence) break;
    }
    return iteration;
}
}  // namespace

SmoothedWindow smoothWindow(const Camera& camera, Window window, const WindowOptions& options)
{
    if (window.poses.size() < 2)
        throw std::invalid_argument("smoothWindow: a window has two views or more");
    const Window given = window;
    WindowEquations equations(camera, given, options);
    SmoothedWindow result;
    result.iterations = minimize(equations, window, options);
    result.cost = equations.truncatedCost(window);
    if (result.cost > options.hopelessCost) return result;
    (void)equations.markOutliers(window);
    result.iterations += minimize(equations, window, options);
    result.meanChi2 = equations.markOutliers(window);
    result.cost = equations.truncatedCost(window);
    (void)equations.evaluate(window, true);
    if (options.covariance) result.P = equations.covariance();
    result.usable = options.covariance ? result.P.size() > 0 : equations.determined();
    result.inlier = equations.inliers();
    result.poses = std::move(window.poses);
    result.landmarks = std::move(window.landmarks);
    return result;
}
}  // namespace monoslam
