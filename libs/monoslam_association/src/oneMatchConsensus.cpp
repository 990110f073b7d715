// SPDX-License-Identifier: BSD-3-Clause
#include "oneMatchConsensus.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace monoslam
{
namespace
{
constexpr long kMostHypotheses = 1000;

struct Match
{
    LandmarkSlot slot;
    PixelMeasurement pixel;
    double threshold_px = 0.0;
};

std::vector<Match> listMatches(const ConsensusProblem& problem, double th_sigma)
{
    std::vector<Match> matches;
    for (std::size_t i = 0; i < problem.matches.rows.size(); ++i)
    {
        const Eigen::Index row = problem.matches.rows[i];
        const auto& landmark = problem.matches.prediction->rows[static_cast<std::size_t>(row)];
        const auto index = static_cast<std::size_t>(problem.prior.find(landmark.id));
        const Candidate& candidate = problem.matches.candidates[i].front();
        matches.push_back({problem.prior.landmarks[index],
                           {row, candidate.z, candidate.R},
                           th_sigma * std::sqrt(0.5 * candidate.R.trace())});
    }
    return matches;
}

long hypothesesFor(double outlierShare, double p)
{
    if (outlierShare <= 0.0) return 1;
    const double needed = std::ceil(std::log(1.0 - p) / std::log(outlierShare));
    return std::clamp(static_cast<long>(needed), 1L, kMostHypotheses);
}

/** Inliers of the state that match k gives; k itself is one, whatever the bend leaves of it. */
std::vector<int> agreeing(const ConsensusProblem& problem, const std::vector<Match>& matches,
                          std::size_t k)
{
    const Eigen::VectorXd x =
        ekfUpdateMean(problem.prior, *problem.matches.prediction, {matches[k].pixel});
    std::vector<int> inliers(matches.size(), -1);
    for (std::size_t j = 0; j < matches.size(); ++j)
    {
        const auto seen = problem.view.linearize(x, matches[j].slot);
        if (seen && (matches[j].pixel.z - seen->h).norm() < matches[j].threshold_px) inliers[j] = 0;
    }
    inliers[k] = 0;
    return inliers;
}
}  // namespace

std::vector<int> largestConsensus(const ConsensusProblem& problem, const ConsensusOptions& options,
                                  AssociationCounters& counters, std::mt19937& rng)
{
    const std::vector<Match> matches = listMatches(problem, options.th_sigma);
    const std::size_t n = matches.size();
    std::vector<int> best(n, -1);
    if (n == 0) return best;
    const bool enumerate = n <= static_cast<std::size_t>(options.enumerate_up_to);
    std::uniform_int_distribution<std::size_t> draw(0, n - 1);
    long wanted = enumerate ? static_cast<long>(n) : kMostHypotheses;
    std::ptrdiff_t most = 0;
    for (long i = 0; i < wanted; ++i)
    {
        std::vector<int> inliers =
            agreeing(problem, matches, enumerate ? static_cast<std::size_t>(i) : draw(rng));
        ++counters.nodes;
        const std::ptrdiff_t count = std::count(inliers.begin(), inliers.end(), 0);
        if (count <= most) continue;
        most = count;
        best = std::move(inliers);
        const double outlierShare = 1.0 - static_cast<double>(most) / static_cast<double>(n);
        if (!enumerate) wanted = hypothesesFor(outlierShare, options.p);
    }
    return best;
}
}  // namespace monoslam
