// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "Arguments.h"
#include "Figures.h"
#include "Strategies.h"
#include "monoslam_eval/drawProblem.h"

namespace monoslam
{
struct Cell
{
    ProblemShape shape;
    std::vector<Figures> figures;  ///< one a strategy
};

/** Draws and solves all problems of all cells, a cell a worker at a time; tells how far it is on
 *  stderr. All but the times is the same for any number of workers.
 *  \throw std::invalid_argument if there is no cell */
[[nodiscard]] std::vector<Cell> runGrid(const Arguments& arguments, const Strategies& strategies);
}  // namespace monoslam
