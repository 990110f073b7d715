// SPDX-License-Identifier: BSD-3-Clause
#include "Cell.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "monoslam_association/jointCompatibility.h"

namespace monoslam
{
namespace
{
constexpr double kTau = 0.95;

std::mt19937 generatorOf(const Cell& cell, unsigned seed, unsigned purpose)
{
    std::seed_seq sequence{seed, purpose, static_cast<unsigned>(cell.covariance),
                           static_cast<unsigned>(cell.m)};
    return std::mt19937(sequence);
}
}  // namespace

std::vector<Cell> listCells()
{
    std::vector<Cell> cells;
    for (const auto covariance : {CovarianceKind::Independent, CovarianceKind::Filter})
        for (const Eigen::Index m : {12, 25, 50, 100})
            for (const auto outliers : {OutlierKind::Uniform, OutlierKind::Cluster})
                for (const Eigen::Index r : {0, 1, 2, 5, 10})
                    if (4 * r <= m && (outliers == OutlierKind::Uniform || r >= 2))
                        cells.push_back({covariance, outliers, m, r});
    return cells;
}

void printCell(const Cell& cell)
{
    std::printf("| %s | %s | %ld | %ld |",
                cell.covariance == CovarianceKind::Filter ? "EKF" : "IND",
                cell.outliers == OutlierKind::Cluster ? "CL" : "UN", static_cast<long>(cell.m),
                static_cast<long>(cell.r));
}

std::vector<DrawnProblem> ProblemSource::draw(const Cell& cell)
{
    if (priors_.empty() || last_.covariance != cell.covariance || last_.m != cell.m)
    {
        priors_.clear();
        for (unsigned seed = 0; seed < seeds_; ++seed)
        {
            std::mt19937 rng = generatorOf(cell, seed, 0);
            priors_.push_back(drawJointPrior(landmarksFor(cell.m), cell.covariance, rng));
        }
    }
    last_ = cell;
    const Chi2Table table(kTau, 2 * cell.m);
    std::vector<DrawnProblem> drawn;
    for (unsigned seed = 0; seed < seeds_; ++seed)
    {
        std::mt19937 rng = generatorOf(cell, seed, 1);
        JointPairs pairs = drawJointPairs(priors_[seed], {cell.m, cell.r, cell.outliers}, rng);
        SubsetProblem problem{std::move(pairs.S), std::move(pairs.nu), {}};
        for (Eigen::Index kept = cell.m; kept >= 0; --kept)
            problem.limits.push_back(table(2 * kept));
        drawn.push_back({std::move(problem), std::move(pairs.wrong)});
    }
    return drawn;
}

double quantile(std::vector<double> values, double q)
{
    std::sort(values.begin(), values.end());
    const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(values.size())));
    return values[std::max<std::size_t>(rank, 1) - 1];
}
}  // namespace monoslam
