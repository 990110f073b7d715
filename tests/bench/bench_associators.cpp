// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <numeric>
#include <vector>

#include "../support/subsetProblems.h"

/** Joint searches on m pairs of which r are wrong; a fresh problem every iteration.
 *  Columns: share proved optimal, nodes and pairs removed in the mean. */
namespace
{
using namespace monoslam;
using test::jcbbProblem;

const Chi2Table kTable(0.95, 400);
constexpr std::size_t kProblems = 100;

std::vector<SubsetProblem> problems(benchmark::State& state)
{
    std::mt19937 rng(1);
    std::vector<SubsetProblem> made;
    for (std::size_t i = 0; i < kProblems; ++i)
        made.push_back(test::randomProblem(state.range(0), state.range(1), kTable, rng));
    return made;
}

void hohct(benchmark::State& state, SubsetSearch search)
{
    const auto made = problems(state);
    std::size_t run = 0;
    double proved = 0.0, nodes = 0.0, removed = 0.0;
    for (auto _ : state)
    {
        const SubsetResult result = largestCompatibleSubset(made[run++ % kProblems], search);
        proved += result.proved ? 1.0 : 0.0;
        nodes += static_cast<double>(result.nodes);
        removed += static_cast<double>(result.removed.size());
    }
    const auto mean = benchmark::Counter::kAvgIterations;
    state.counters["proved"] = benchmark::Counter(proved, mean);
    state.counters["nodes"] = benchmark::Counter(nodes, mean);
    state.counters["removed"] = benchmark::Counter(removed, mean);
}

void jcbb(benchmark::State& state)
{
    const auto made = problems(state);
    std::size_t run = 0;
    double finished = 0.0, nodes = 0.0;
    for (auto _ : state)
    {
        const JcbbResult result =
            jointBranchAndBound(jcbbProblem(made[run++ % kProblems]), kTable, {});
        finished += result.finished ? 1.0 : 0.0;
        nodes += static_cast<double>(result.nodes);
    }
    state.counters["proved"] = benchmark::Counter(finished, benchmark::Counter::kAvgIterations);
    state.counters["nodes"] = benchmark::Counter(nodes, benchmark::Counter::kAvgIterations);
}

void factorizeAndInvert(benchmark::State& state)
{
    const auto made = problems(state);
    std::size_t run = 0;
    for (auto _ : state)
    {
        const SubsetProblem& problem = made[run++ % kProblems];
        benchmark::DoNotOptimize(DowndatingD2(problem.S, problem.nu).d2());
    }
}

void sizes(benchmark::internal::Benchmark* bench)
{
    bench->Args({12, 1})->Args({12, 2})->Args({25, 2})->Args({25, 5})->Args({50, 0})->Args({50, 5});
    bench->Args({60, 3})->Args({60, 10})->Args({100, 5})->Args({100, 10});
    bench->Unit(benchmark::kMicrosecond);
}
}  // namespace

BENCHMARK(factorizeAndInvert)->Apply(sizes);
BENCHMARK_CAPTURE(hohct, greedy, SubsetSearch::Greedy)->Apply(sizes);
BENCHMARK_CAPTURE(hohct, automatic, SubsetSearch::Automatic)->Apply(sizes);
BENCHMARK_CAPTURE(hohct, removal, SubsetSearch::Removal)->Apply(sizes);
BENCHMARK_CAPTURE(hohct, reinsertion, SubsetSearch::Reinsertion)->Apply(sizes);
BENCHMARK_CAPTURE(hohct, branch_and_bound, SubsetSearch::BranchAndBound)->Apply(sizes);
BENCHMARK_CAPTURE(hohct, downdate, SubsetSearch::Downdate)->Args({12, 1})->Args({12, 2});
BENCHMARK_CAPTURE(hohct, printed, SubsetSearch::Printed)->Args({12, 1})->Args({12, 2});
BENCHMARK(jcbb)->Apply(sizes);
