// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_association/largestCompatibleSubset.h"
#include "monoslam_eval/JointPairs.h"

namespace monoslam
{
/** A row of the tables: one kind and size of problem. */
struct Cell
{
    CovarianceKind covariance = CovarianceKind::Independent;
    OutlierKind outliers = OutlierKind::Uniform;
    Eigen::Index m = 0;
    Eigen::Index r = 0;
};

/** r = 0, 1, 2, 5, 10 up to a quarter of m = 12, 25, 50, 100; clusters of two and more. */
[[nodiscard]] std::vector<Cell> listCells();

/** "| IND | UN | 50 | 5 |" */
void printCell(const Cell& cell);

struct DrawnProblem
{
    SubsetProblem problem;
    std::vector<char> wrong;
};

/** Problems of one cell, one a seed. Cells of one covariance and m share their priors, which take
 *  most of the time, and are drawn only once if they are asked for one after the other. */
class ProblemSource
{
   public:
    explicit ProblemSource(unsigned seeds) : seeds_(seeds) {}
    [[nodiscard]] std::vector<DrawnProblem> draw(const Cell& cell);

   private:
    unsigned seeds_;
    Cell last_;
    std::vector<JointPrior> priors_;
};

/** The q-quantile of some numbers. */
[[nodiscard]] double quantile(std::vector<double> values, double q);
}  // namespace monoslam
