// SPDX-License-Identifier: BSD-3-Clause
#include "run.h"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <stdexcept>

#include "Config.h"
#include "Filter.h"
#include "Outputs.h"
#include "StepPairs.h"
#include "compareWithTruth.h"
#include "monoslam_support/ThreadClock.h"

namespace monoslam
{
namespace
{
/** The first line of an MRPT exception that says something, without its stack trace. */
std::string essence(const std::exception& error)
{
    const std::string text = error.what();
    const auto begin = text.find("Message:");
    if (begin == std::string::npos) return text.substr(0, text.find('\n'));
    const auto start = text.find_first_not_of(" \n", begin + 8);
    return text.substr(start, text.find('\n', start) - start);
}

double processAll(const Config& config, StepPairs& steps, Filter& filter, Outputs& outputs)
{
    double longest_ms = 0.0;
    while (auto step = steps.next())
    {
        if (step->entries < config.firstEntry) continue;
        ThreadClock clock;
        try
        {
            filter.process(step->action, step->observations);
        }
        catch (const std::exception& e)
        {
            throw std::runtime_error(config.rawlog + ": entry " + std::to_string(step->entries) +
                                     ": " + essence(e));
        }
        longest_ms = std::max(longest_ms, clock.lap_ms());
        outputs.add(*step, filter);
    }
    return longest_ms;
}

void reportPath(const Outputs& outputs)
{
    const auto& frames = outputs.frames();
    const PathErrors errors = comparePaths(outputs.path(), outputs.truth(), frames);
    std::printf("path: RMSE %.6f m, largest %.6f m, %zu steps\n", errors.rmse_m, errors.largest_m,
                errors.steps);
    std::vector<std::size_t> rows(frames.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    if (rows == frames) return;
    std::printf("path, step by row of the truth, as kf-slam draws it: RMSE %.6f m\n",
                comparePaths(outputs.path(), outputs.truth(), rows).rmse_m);
}

void report(const Config& config, const Filter& filter, const Outputs& outputs, double longest_ms)
{
    const JointAssociationCounters c = filter.counters();
    std::printf("%zu steps, the longest %.1f ms; %zu landmarks\n", outputs.path().size(),
                longest_ms, filter.landmarks().size());
    if (c.observations > 0)
        std::printf(
            "%ld observations without ID: %ld assigned, %ld ignored, %ld nodes, %ld unproved; %ld "
            "landmarks removed\n",
            c.observations, c.assigned, c.ignored, c.nodes, c.unproved, c.removed);
    if (!outputs.truth().empty()) reportPath(outputs);
    if (!config.truthOfLandmarks.empty())
        std::printf(
            "%s\n",
            landmarkErrors(filter.landmarks(), config.truthOfLandmarks, outputs.haveIds()).c_str());
    std::printf("outputs in %s\n", config.output.c_str());
}
}  // namespace

int run(const Arguments& arguments)
{
    const Config config = loadConfig(arguments);
    for (const auto& warning : config.warnings)
        std::fprintf(stderr, "kf-slam-joint: %s\n", warning.c_str());
    const auto filter = makeFilter(config);
    StepPairs steps(config.rawlog);
    Outputs outputs(config, arguments.force);
    const double longest_ms = processAll(config, steps, *filter, outputs);
    report(config, *filter, outputs, longest_ms);
    return 0;
}
}  // namespace monoslam
