// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/drawParents.h"

#include <algorithm>
#include <numeric>

namespace monoslam
{
namespace
{
bool stillManifold(const std::vector<double>& weights, double share)
{
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    const double squares = std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
    return sum * sum / squares >= share * static_cast<double>(weights.size());
}
}  // namespace

std::vector<std::size_t> drawParents(const std::vector<double>& weights, std::size_t count,
                                     Resampling scheme, double neffShare, std::mt19937& rng)
{
    if (scheme == Resampling::Neff && weights.size() == count && stillManifold(weights, neffShare))
        return {};
    std::vector<double> cumulated(weights.size());
    std::partial_sum(weights.begin(), weights.end(), cumulated.begin());
    std::uniform_real_distribution<double> uniform;
    const double first = uniform(rng);
    std::vector<double> places(count);
    for (std::size_t i = 0; i < count; ++i)
        if (scheme == Resampling::Multinomial)
            places[i] = i == 0 ? first : uniform(rng);
        else
            places[i] = (static_cast<double>(i) + first) / static_cast<double>(count);
    std::sort(places.begin(), places.end());
    std::vector<std::size_t> parents;
    for (const double place : places)
    {
        const auto at =
            std::upper_bound(cumulated.begin(), cumulated.end(), place * cumulated.back());
        parents.push_back(
            std::min(static_cast<std::size_t>(at - cumulated.begin()), weights.size() - 1));
    }
    return parents;
}
}  // namespace monoslam
