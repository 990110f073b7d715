// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/MhdaRule.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace monoslam
{
MhdaRule::MhdaRule(const MhdaRuleOptions& options, const CandidateLikelihood& likelihood,
                   double gate, const std::mt19937& rng)
    : options_(options), likelihood_(likelihood), gate_(gate), rng_(rng)
{
}

std::size_t MhdaRule::draw(const std::vector<double>& weights, double sum)
{
    double place = std::uniform_real_distribution<double>(0.0, sum)(rng_);
    std::size_t i = 0;
    while (i + 1 < weights.size() && place >= weights[i]) place -= weights[i++];
    return i;
}

std::optional<std::size_t> MhdaRule::next(const SequentialUpdate& update)
{
    listEfficiencies(update, options_.target, gate_, efficiencies_);
    if (efficiencies_.empty()) return std::nullopt;
    weights_.clear();
    for (const auto& entry : efficiencies_) weights_.push_back(entry.bitsPerPixel2);
    double sum = std::accumulate(weights_.begin(), weights_.end(), 0.0);
    if (!(sum > 0.0))
    {
        weights_.assign(efficiencies_.size(), 1.0);
        sum = static_cast<double>(weights_.size());
    }
    return efficiencies_[draw(weights_, sum)].landmark;
}

int MhdaRule::accept(const PredictedLandmark& landmark, const std::vector<Candidate>& candidates)
{
    // The last entry is "not found".
    weights_.clear();
    for (const Candidate& candidate : candidates)
        weights_.push_back(likelihood_.logFound(landmark, candidate));
    weights_.push_back(likelihood_.logMissed());
    const auto likeliest = std::max_element(weights_.begin(), weights_.end());
    const double largest = *likeliest;
    std::size_t chosen = static_cast<std::size_t>(likeliest - weights_.begin());
    double factor = largest;
    double chosenRatio = largest;
    if (options_.association == AssociationChoice::Sample)
    {
        for (double& weight : weights_) weight = std::exp(weight - largest);
        const double sum = std::accumulate(weights_.begin(), weights_.end(), 0.0);
        chosen = draw(weights_, sum);
        factor = largest + std::log(sum);
        chosenRatio = largest + std::log(weights_[chosen]);
    }
    const int candidate = chosen < candidates.size() ? static_cast<int>(chosen) : -1;
    if (options_.weight_model == WeightModel::Literal)
        factor += logLiteral(landmark, candidates, candidate) - chosenRatio;
    logWeight_ += factor;
    clutter_ += static_cast<long>(candidates.size()) - (candidate >= 0 ? 1 : 0);
    return candidate;
}

double MhdaRule::logLiteral(const PredictedLandmark& landmark,
                            const std::vector<Candidate>& candidates, int chosen) const
{
    const auto n = static_cast<double>(candidates.size());
    const double logArea = std::log(M_PI * gate_) + 0.5 * std::log(landmark.S.determinant());
    if (chosen < 0) return likelihood_.logMissed() - n * logArea;
    const Candidate& candidate = candidates[static_cast<std::size_t>(chosen)];
    const Eigen::Matrix2d S = landmark.S - landmark.R + candidate.R;
    return likelihood_.logDetection() +
           CandidateLikelihood::logDensity(candidate.z - landmark.h, S) +
           likelihood_.logScoreRatio(candidate.score) - std::log(n) - (n - 1.0) * logArea;
}

double MhdaRule::logWeight() const
{
    if (options_.weight_model == WeightModel::Ratio) return logWeight_;
    const double expected = likelihood_.options().clutter_per_image;
    const auto count = static_cast<double>(clutter_);
    return logWeight_ + count * std::log(expected) - expected - std::lgamma(count + 1.0);
}
}  // namespace monoslam
