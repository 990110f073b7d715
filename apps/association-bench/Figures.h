// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monoslam_eval/solveProblem.h"

namespace monoslam
{
/** One strategy's solutions, summed up. */
struct Figures
{
    long problems = 0;
    long accepted = 0;
    long right = 0;
    long present = 0;
    long jointlyCorrect = 0;
    long complete = 0;
    long nodes = 0;
    long d2Evaluations = 0;
    long notProved = 0;
    long capped = 0;
    std::vector<double> associate_ms;  ///< of each problem
    std::vector<double> total_ms;

    void add(const Solution& solution);
    void add(const Figures& others);
};

/** The q-quantile, the lower of two; 0 of nothing. */
[[nodiscard]] double quantile(std::vector<double> values, double q);
}  // namespace monoslam
