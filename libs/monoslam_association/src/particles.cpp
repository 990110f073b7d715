// SPDX-License-Identifier: BSD-3-Clause
#include "particles.h"

#include <algorithm>
#include <cmath>

namespace monoslam
{
std::vector<double> weightsOf(const Mixture& mixture)
{
    double largest = mixture.front().logWeight, sum = 0.0;
    for (const auto& particle : mixture) largest = std::max(largest, particle.logWeight);
    std::vector<double> weights;
    for (const auto& particle : mixture)
        sum += weights.emplace_back(std::exp(particle.logWeight - largest));
    for (double& weight : weights) weight /= sum;
    return weights;
}

Mixture descend(Mixture mixture, const std::vector<std::size_t>& parents)
{
    const auto before = [&mixture](std::size_t a, std::size_t b)
    { return b < mixture[a].separation.size() ? mixture[a].separation[b] : 0; };
    Mixture children(parents.size());
    for (std::size_t i = 0; i < parents.size(); ++i)
    {
        WeightedBelief& child = children[i];
        child.logWeight = -std::log(static_cast<double>(parents.size()));
        for (const std::size_t other : parents)
            child.separation.push_back(other == parents[i] ? 0 : before(parents[i], other));
    }
    for (std::size_t i = 0; i < parents.size(); ++i)
    {
        const bool last = i + 1 == parents.size() || parents[i + 1] != parents[i];
        Belief& parent = mixture[parents[i]].belief;
        children[i].belief = last ? std::move(parent) : parent;
    }
    return children;
}

void age(Mixture& mixture)
{
    for (std::size_t i = 0; i < mixture.size(); ++i)
        for (std::size_t j = 0; j < mixture.size(); ++j)
            if (i != j) ++mixture[i].separation[j];
}

void normalize(Mixture& particles)
{
    const std::vector<double> weights = weightsOf(particles);
    for (std::size_t i = 0; i < weights.size(); ++i) particles[i].logWeight = std::log(weights[i]);
}
}  // namespace monoslam
