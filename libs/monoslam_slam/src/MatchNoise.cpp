// SPDX-License-Identifier: BSD-3-Clause
#include "MatchNoise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace monoslam
{
namespace
{
constexpr std::size_t kFewest = 10;    ///< residuals that make a median
constexpr double kMedianChi2 = 1.386;  ///< of chi2(2)
constexpr double kForget = 0.05;       ///< weight of one frame in the running noise
}  // namespace

MatchNoise::MatchNoise(const SearchOptions& options)
    : least_(options.sigma_floor_px * options.sigma_floor_px),
      most_(options.max_sigma_floor_px * options.max_sigma_floor_px)
{
}

void MatchNoise::adapt(std::vector<double> squares)
{
    if (squares.size() >= kFewest)
    {
        const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
        std::nth_element(squares.begin(), middle, squares.end());
        sigma2_ += kForget * (*middle / kMedianChi2 - sigma2_);
    }
    sigma2_ = std::clamp(sigma2_, least_, std::max(least_, most_));
}

double MatchNoise::sigma_px() const
{
    return std::sqrt(sigma2_);
}
double MatchNoise::floor_px() const
{
    return std::sqrt(std::max(sigma2_, least_));
}
}  // namespace monoslam
