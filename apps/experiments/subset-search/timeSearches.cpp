// SPDX-License-Identifier: BSD-3-Clause
#include "timeSearches.h"

#include <algorithm>
#include <cstdio>

#include "monoslam_association/jointBranchAndBound.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_support/ThreadClock.h"

namespace monoslam
{
namespace
{
constexpr int kRepeats = 3;
constexpr double kLongRun_ms = 20.0;
/** About a second. */
const SubsetBudget kBudget{0.0, 10000000};
constexpr long kJcbbNodes = 20000;
const Chi2Table kTable(0.95, 400);

/** Least thread CPU time of some runs, of one if that is long. */
template <class Run>
double leastTime_ms(const Run& run)
{
    double least = 0.0;
    for (int i = 0; i < kRepeats && least < kLongRun_ms; ++i)
    {
        ThreadClock clock;
        run();
        const double ms = clock.lap_ms();
        least = i == 0 ? ms : std::min(least, ms);
    }
    return least;
}

struct Timings
{
    std::vector<double> inverse_us, hohct_us, nodes, jcbb_us;
    double removed = 0.0;
    int proved1 = 0, proved10 = 0, proved100 = 0, proved = 0;
    int isTruth = 0, isGreedy = 0, jcbbFinished = 0, jcbbAsLarge = 0;
};

bool isTruth(const std::vector<Eigen::Index>& removed, const std::vector<char>& wrong)
{
    const auto count = std::count(wrong.begin(), wrong.end(), 1);
    return static_cast<std::ptrdiff_t>(removed.size()) == count &&
           std::all_of(removed.begin(), removed.end(),
                       [&wrong](Eigen::Index j)
                       { return wrong[static_cast<std::size_t>(j)] == 1; });
}

void timeHohct(const DrawnProblem& drawn, Timings& timings, SubsetResult& result)
{
    const SubsetProblem& problem = drawn.problem;
    timings.inverse_us.push_back(
        1e3 * leastTime_ms([&] { return DowndatingD2(problem.S, problem.nu).d2(); }));
    const double ms = leastTime_ms(
        [&] { result = largestCompatibleSubset(problem, SubsetSearch::Automatic, kBudget); });
    timings.hohct_us.push_back(1e3 * ms);
    timings.nodes.push_back(static_cast<double>(result.nodes));
    timings.removed += static_cast<double>(result.removed.size());
    timings.proved += result.proved ? 1 : 0;
    timings.proved1 += result.proved && ms <= 1.0 ? 1 : 0;
    timings.proved10 += result.proved && ms <= 10.0 ? 1 : 0;
    timings.proved100 += result.proved && ms <= 100.0 ? 1 : 0;
    timings.isTruth += isTruth(result.removed, drawn.wrong) ? 1 : 0;
    const auto greedy = largestCompatibleSubset(problem, SubsetSearch::Greedy);
    timings.isGreedy += greedy.removed == result.removed ? 1 : 0;
}

void timeJcbb(const SubsetProblem& problem, std::size_t largest, Timings& timings)
{
    JcbbProblem jcbb{&problem.S, {}, {}};
    for (Eigen::Index j = 0; j < problem.pairs(); ++j)
        jcbb.pairs.push_back({JointPair{j, problem.nu.segment<2>(2 * j)}});
    JcbbResult result;
    timings.jcbb_us.push_back(
        1e3 * leastTime_ms(
                  [&] {
                      result = jointBranchAndBound(jcbb, kTable, {true, kJcbbNodes});
                  }));
    const auto none = std::count(result.chosen.begin(), result.chosen.end(), -1);
    timings.jcbbFinished += result.finished ? 1 : 0;
    timings.jcbbAsLarge += result.chosen.size() - static_cast<std::size_t>(none) == largest ? 1 : 0;
}

void printRow(const Cell& cell, const Timings& t)
{
    const auto n = static_cast<double>(t.hohct_us.size());
    const auto share = [n](int count) { return 100.0 * count / n; };
    const double median_us = quantile(t.hohct_us, 0.5);
    printCell(cell);
    std::printf(" %.1f | %.0f / %.0f / %.0f | %.2f | %.0f | %.0f | %.0f | %.0f |", t.removed / n,
                median_us, quantile(t.hohct_us, 0.9), quantile(t.hohct_us, 1.0),
                median_us / quantile(t.inverse_us, 0.5), share(t.proved1), share(t.proved10),
                share(t.proved100), share(t.proved));
    std::printf(" %.0f / %.0f | %.0f | %.0f | %.0f / %.0f | %.0f | %.0f |\n",
                quantile(t.nodes, 0.5), quantile(t.nodes, 0.9), share(t.isGreedy), share(t.isTruth),
                quantile(t.jcbb_us, 0.5), quantile(t.jcbb_us, 0.9), share(t.jcbbFinished),
                share(t.jcbbAsLarge));
    std::fflush(stdout);
}
}  // namespace

void timeSearches(unsigned seeds)
{
    std::printf(
        "| cov | outliers | m | r | removed | us: median / 90 %% / max | ratio | proved in 1 ms | "
        "10 ms | 100 ms | at all | nodes: median / 90 %% | greedy is exact | exact is truth | "
        "JCBB us: median / 90 %% | finished | as large |\n"
        "|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    ProblemSource source(seeds);
    for (const Cell& cell : listCells())
    {
        Timings timings;
        for (const DrawnProblem& drawn : source.draw(cell))
        {
            SubsetResult result;
            timeHohct(drawn, timings, result);
            timeJcbb(drawn.problem, drawn.wrong.size() - result.removed.size(), timings);
        }
        printRow(cell, timings);
    }
}
}  // namespace monoslam
