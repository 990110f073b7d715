// SPDX-License-Identifier: BSD-3-Clause
#include "drawAssignment.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "monoslam_association/ConditionalPairs.h"

namespace monoslam
{
namespace
{
const double kLogTwoPi = std::log(2.0 * std::acos(-1.0));

/** Uniform in 0 .. n - 1; std::shuffle would differ from one library to the next. */
std::size_t drawBelow(std::size_t n, std::mt19937& rng)
{
    return static_cast<std::size_t>(static_cast<double>(rng()) / 4294967296.0 *
                                    static_cast<double>(n));
}

std::vector<std::size_t> drawOrder(std::size_t n, std::mt19937& rng)
{
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[drawBelow(i, rng)]);
    return order;
}

/** Index drawn in proportion to exp(logs), and ln of their sum. */
std::size_t drawFrom(const std::vector<double>& logs, std::mt19937& rng, double& logSum)
{
    const double largest = *std::max_element(logs.begin(), logs.end());
    double sum = 0.0;
    for (const double l : logs) sum += std::exp(l - largest);
    logSum = largest + std::log(sum);
    double left = static_cast<double>(rng()) / 4294967296.0 * sum;
    std::size_t i = 0;
    for (; i + 1 < logs.size(); ++i)
    {
        left -= std::exp(logs[i] - largest);
        if (left < 0.0) break;
    }
    return i;
}
}  // namespace

DrawnAssignment drawAssignment(const AssignmentProblem& problem, const DetectionModel& model,
                               std::mt19937& rng)
{
    const double logOdds = std::log(model.p_detection / (1.0 - model.p_detection));
    const auto O = static_cast<double>(problem.dimension);
    ConditionalPairs stack(problem);
    std::set<Eigen::Index> used;
    DrawnAssignment drawn;
    AssignmentResult& result = drawn.assignment;
    result.chosen.assign(problem.items.size(), -1);
    for (const std::size_t i : drawOrder(problem.items.size(), rng))
    {
        std::vector<double> logs{std::log(model.clutter_density)};
        std::vector<int> candidates{-1};
        for (std::size_t c = 0; c < problem.items[i].size(); ++c)
        {
            const AssignmentPair& pair = problem.items[i][c];
            const ConditionalPairs::Gain gain = stack.gain(pair);
            if (used.count(pair.use) > 0 || !std::isfinite(gain.nis)) continue;
            logs.push_back(logOdds - 0.5 * (gain.nis + gain.logDet + O * kLogTwoPi));
            candidates.push_back(static_cast<int>(c));
        }
        double logSum = 0.0;
        const int chosen = candidates[drawFrom(logs, rng, logSum)];
        drawn.logWeight += logSum;
        ++result.nodes;
        if (chosen < 0) continue;
        const AssignmentPair& pair = problem.items[i][static_cast<std::size_t>(chosen)];
        if (!stack.push(pair)) continue;
        used.insert(pair.use);
        result.chosen[i] = chosen;
    }
    result.pairs = stack.pairs();
    result.d2 = stack.d2();
    result.logDet = stack.logDet();
    return drawn;
}
}  // namespace monoslam
