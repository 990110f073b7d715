// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "monoslam_association/export.h"

namespace monoslam
{
enum class Resampling
{
    Multinomial,  ///< independent draws, every frame: the paper
    Systematic,   ///< one draw and equal steps: equal weights all survive
    Neff,         ///< systematic, only when the effective number falls below a share of P
};

/** Which particle each of \p count new ones comes from, ascending; \p weights need not be normalised.
 *  Empty: nothing is drawn, all stay as they are (Neff, if there are as many as wanted). */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT std::vector<std::size_t> drawParents(
    const std::vector<double>& weights, std::size_t count, Resampling scheme, double neffShare,
    std::mt19937& rng);
}  // namespace monoslam
