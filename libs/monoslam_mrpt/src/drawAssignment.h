// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "monoslam_association/AssignmentProblem.h"

namespace monoslam
{
/** What an observation may be besides one of the landmarks. */
struct DetectionModel
{
    double p_detection = 0.9;       ///< of a landmark in view
    double clutter_density = 3e-3;  ///< clutter and new landmarks per unit of z: 1 / (m rad^(O-1))
};

struct DrawnAssignment
{
    AssignmentResult assignment;
    double logWeight = 0.0;  ///< ln of the product of the normalisers
};

/** An assignment drawn landmark by landmark, in random order, each given the pairs drawn before. A
 *  landmark chooses among all items that may be it: an echo competes with what it is an echo of.
 *
 *      l_j = P_D / (1 - P_D) N(nu_j; 0, S_j | drawn) / clutter density,   l_0 = 1 for "missed"
 *      p_j = l_j / sum,   ln w += ln sum,   besides the clutter density of every item
 *
 * The weight is that of the optimal proposal: the normaliser, not the likelihood of what was drawn,
 * which would count it twice. \see algorithms 7.2, 7.3 */
[[nodiscard]] DrawnAssignment drawAssignment(const AssignmentProblem& problem,
                                             const DetectionModel& model, std::mt19937& rng);
}  // namespace monoslam
