// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "monoslam_eval/drawProblem.h"

namespace monoslam
{
struct CandidateDraw
{
    int count = 1;
    bool absent = false;    ///< the right one is not among them
    Eigen::Vector2d right;  ///< [px]
};

/** What a search finds of one landmark, best score first.
 *  \throw std::invalid_argument if the ellipse has no place for a wrong candidate */
[[nodiscard]] std::vector<Candidate> drawCandidates(const PredictedLandmark& row,
                                                    const CandidateDraw& draw,
                                                    const ProblemDistributions& drawn,
                                                    std::mt19937& rng);
}  // namespace monoslam
