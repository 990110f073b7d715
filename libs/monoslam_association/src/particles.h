// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_filter/Belief.h"

/** Beliefs of a mixture as particles. */
namespace monoslam
{
/** Normalised weights, from their logarithms. */
[[nodiscard]] std::vector<double> weightsOf(const Mixture& mixture);

void normalize(Mixture& particles);

/** Children of the given parents, ascending, each of the same weight. */
[[nodiscard]] Mixture descend(Mixture mixture, const std::vector<std::size_t>& parents);

/** Particles are apart from each other for a frame more. */
void age(Mixture& mixture);
}  // namespace monoslam
