// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <vector>

#include "SyntheticRun.h"

namespace monoslam
{
/** Camera-pose NEES of every frame, averaged over seeded runs, and its 95 % bounds. */
struct AverageNees
{
    std::vector<double> mean;
    Interval bounds;

    [[nodiscard]] bool inside(std::size_t frame) const
    {
        return mean[frame] >= bounds.low && mean[frame] <= bounds.high;
    }
    [[nodiscard]] int insideOfFirst(std::size_t frames) const
    {
        int count = 0;
        for (std::size_t i = 0; i < frames; ++i) count += inside(i) ? 1 : 0;
        return count;
    }
    /** First of ten frames in a row outside the bounds, from 1; 0 = never. */
    [[nodiscard]] int leavesAt() const
    {
        constexpr int kInARow = 10;
        int run = 0;
        for (std::size_t i = 0; i < mean.size(); ++i)
        {
            run = inside(i) ? 0 : run + 1;
            if (run == kInARow) return static_cast<int>(i) + 2 - kInARow;
        }
        return 0;
    }
};

inline AverageNees averageNees(const SyntheticRunOptions& options, int runs, std::size_t frames)
{
    AverageNees result{std::vector<double>(frames, 0.0), chi2MeanBounds(6, runs, 0.95)};
    for (int seed = 0; seed < runs; ++seed)
    {
        SyntheticRun run(options, 1000U + static_cast<unsigned>(seed));
        for (double& mean : result.mean) mean += run.step() / runs;
    }
    return result;
}

inline void print(const char* name, const AverageNees& nees)
{
    std::printf("%s: inside [%.2f, %.2f] in %d of the first 100 frames", name, nees.bounds.low,
                nees.bounds.high, nees.insideOfFirst(100));
    std::printf(", leaves for good at frame %d of %zu (0 = never)\n  frame: NEES ", nees.leavesAt(),
                nees.mean.size());
    for (std::size_t i = 0; i < nees.mean.size(); i += nees.mean.size() / 10)
        std::printf(" %zu: %.2f", i + 1, nees.mean[i]);
    std::printf("\n");
}

/** Four known points, landmarks triangulated against pose clones. */
inline SyntheticRunOptions delayedMetricStart()
{
    return {};
}

/** Four known points, landmarks at once; inverse depth 0.5 +- 0.25 / m (at least 1 m away). */
inline SyntheticRunOptions undelayedMetricStart()
{
    SyntheticRunOptions options;
    options.delayed = false;
    options.secondOrder = true;
    return options;
}

/** No known points: the scale is only in the prior of the inverse depths. */
inline SyntheticRunOptions undelayedFreeStart(double sigma_rho)
{
    SyntheticRunOptions options;
    options.delayed = false;
    options.target = false;
    options.prior = {1.0, sigma_rho, options.sigma_px};
    return options;
}
}  // namespace monoslam
