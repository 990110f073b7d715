// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <cstdio>
#include <ctime>

#include "monoslam_mrpt/MonoSlamKF.h"
#include "randomBelief.h"

/** One frame of the filter without images: predict, all h, H and S, update with half of them; ours
 *  and MRPT's on the same belief. The last row's label is the ratio. */
namespace monoslam
{
namespace
{
constexpr double kDt_s = 1.0 / 30.0;

struct Problem
{
    Camera camera;
    Belief belief;
    std::vector<LandmarkPixel> pixels;
    std::vector<PixelMeasurement> rows;
};

Problem makeProblem(int landmarks)
{
    std::mt19937 rng(11);
    Problem problem;
    problem.belief = randomBelief(rng, problem.camera, {landmarks, 0, false});
    const Prediction prediction =
        predictMeasurements(ekfPredict(problem.belief, {}, kDt_s), problem.camera, {-100.0, 1.0});
    auto rows = randomPixels(rng, prediction);
    rows.resize(static_cast<std::size_t>(landmarks) / 2);
    for (const PixelMeasurement& p : rows)
        problem.pixels.push_back({prediction.rows[static_cast<std::size_t>(p.row)].id, p.z, p.R});
    problem.rows = rows;
    return problem;
}

Belief ourStep(const Problem& problem)
{
    Belief belief = ekfPredict(problem.belief, {}, kDt_s);
    const Prediction prediction = predictMeasurements(belief, problem.camera, {-100.0, 1.0});
    return ekfUpdate(std::move(belief), prediction, problem.rows);
}

Belief mrptStep(const Problem& problem)
{
    return mrptIteration(problem.belief, problem.camera, {}, kDt_s, problem.pixels);
}

double& milliseconds(int landmarks)
{
    static double ours[1024] = {};
    return ours[landmarks];
}

template <typename Step>
double run(benchmark::State& state, const Step& step)
{
    const Problem problem = makeProblem(static_cast<int>(state.range(0)));
    const std::clock_t start = std::clock();
    for (auto _ : state) benchmark::DoNotOptimize(step(problem));
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return 1e3 * seconds / static_cast<double>(state.iterations());
}

void ours(benchmark::State& state)
{
    milliseconds(static_cast<int>(state.range(0))) = run(state, ourStep);
}

void mrpt(benchmark::State& state)
{
    const double ms = run(state, mrptStep);
    char label[32];
    std::snprintf(label, sizeof label, "%.1f times ours",
                  ms / milliseconds(static_cast<int>(state.range(0))));
    state.SetLabel(label);
}

BENCHMARK(ours)->Arg(25)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->MinTime(1.0);
BENCHMARK(mrpt)->Arg(25)->Arg(50)->Arg(100)->Unit(benchmark::kMillisecond)->MinTime(1.0);
}  // namespace
}  // namespace monoslam
