// SPDX-License-Identifier: BSD-3-Clause
#include "drawAssignment.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
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

/** Where a prediction stands among the candidates. */
struct Wish
{
    std::size_t item = 0;
    std::size_t candidate = 0;
};

/** Those of each prediction that has any. */
std::vector<std::vector<Wish>> byPrediction(const AssignmentProblem& problem)
{
    std::map<Eigen::Index, std::vector<Wish>> wishes;
    for (std::size_t i = 0; i < problem.items.size(); ++i)
        for (std::size_t c = 0; c < problem.items[i].size(); ++c)
            wishes[problem.items[i][c].use].push_back({i, c});
    std::vector<std::vector<Wish>> list;
    for (auto& [use, of] : wishes) list.push_back(std::move(of));
    return list;
}
}  // namespace

DrawnAssignment drawAssignment(const AssignmentProblem& problem, const DetectionModel& model,
                               std::mt19937& rng)
{
    const double logOdds = std::log(model.p_detection / (1.0 - model.p_detection));
    const double logClutter = std::log(model.clutter_density);
    const auto O = static_cast<double>(problem.dimension);
    const std::vector<std::vector<Wish>> predictions = byPrediction(problem);
    ConditionalPairs stack(problem);
    DrawnAssignment drawn;
    AssignmentResult& result = drawn.assignment;
    result.chosen.assign(problem.items.size(), -1);
    drawn.logWeight = static_cast<double>(problem.items.size()) * logClutter;
    for (const std::size_t p : drawOrder(predictions.size(), rng))
    {
        std::vector<double> logs{0.0};  // missed
        std::vector<const Wish*> wishes{nullptr};
        for (const Wish& wish : predictions[p])
        {
            const ConditionalPairs::Gain gain =
                stack.gain(problem.items[wish.item][wish.candidate]);
            if (result.chosen[wish.item] >= 0 || !std::isfinite(gain.nis)) continue;
            logs.push_back(logOdds - 0.5 * (gain.nis + gain.logDet + O * kLogTwoPi) - logClutter);
            wishes.push_back(&wish);
        }
        double logSum = 0.0;
        const Wish* chosen = wishes[drawFrom(logs, rng, logSum)];
        drawn.logWeight += logSum;
        ++result.nodes;
        if (chosen && stack.push(problem.items[chosen->item][chosen->candidate]))
            result.chosen[chosen->item] = static_cast<int>(chosen->candidate);
    }
    result.pairs = stack.pairs();
    result.d2 = stack.d2();
    result.logDet = stack.logDet();
    return drawn;
}
}  // namespace monoslam
