// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_eval/JointPairs.h"
#include "subsetProblems.h"

namespace monoslam::test
{
/** What is to be drawn. */
struct DrawnKind
{
    CovarianceKind covariance;
    OutlierKind outliers;
};
constexpr DrawnKind kDrawnKinds[] = {{CovarianceKind::Independent, OutlierKind::Uniform},
                                     {CovarianceKind::Independent, OutlierKind::Cluster},
                                     {CovarianceKind::Filter, OutlierKind::Uniform},
                                     {CovarianceKind::Filter, OutlierKind::Cluster}};

inline SubsetProblem problemOf(const JointPairs& pairs, const Chi2Table& table)
{
    return {pairs.S, pairs.nu, limitsFor(pairs.nu.size() / 2, table)};
}

/** m pairs of which r are wrong, of the seed's kind. */
inline SubsetProblem drawProblem(Eigen::Index m, Eigen::Index r, const Chi2Table& table,
                                 unsigned seed)
{
    std::mt19937 rng(seed);
    const DrawnKind kind = kDrawnKinds[seed % 4];
    const JointPrior prior = drawJointPrior(landmarksFor(m), kind.covariance, rng);
    return problemOf(drawJointPairs(prior, {m, r, kind.outliers}, rng), table);
}
}  // namespace monoslam::test
