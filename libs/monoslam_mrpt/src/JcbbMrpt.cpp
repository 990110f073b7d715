// SPDX-License-Identifier: BSD-3-Clause
#include "JcbbMrpt.h"

#include <mrpt/slam/data_association.h>

#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "monoslam_association/jointCompatibility.h"
#include "runInChild.h"

namespace monoslam
{
using mrpt::math::CMatrixDouble;

namespace
{
/** u, v, and the number of the landmark. */
constexpr Eigen::Index kNumbers = 3;
/** Between the numbers of two landmarks, whose variance is 1: no gate reaches so far. */
constexpr double kNumberStep = 1e6;

/** Probability that three numbers stay within the tau-quantile of two: P(chi2(3) < chi2(2, tau)). */
double quantileOfThree(double tau)
{
    const double half = 0.5 * chi2Limit(2, tau);
    return std::erf(std::sqrt(half)) - 2.0 * std::sqrt(half / std::acos(-1.0)) * std::exp(-half);
}

/** A frame's problem in MRPT's words. */
struct MrptProblem
{
    CMatrixDouble Y;                                  ///< predictions, a row each
    CMatrixDouble S;                                  ///< their joint covariance, with R
    CMatrixDouble Z;                                  ///< pixels, a row each
    std::vector<std::pair<std::size_t, int>> pixels;  ///< landmark and candidate of each
};

CMatrixDouble covarianceOf(const AssociationProblem& problem)
{
    const auto m = static_cast<Eigen::Index>(problem.rows.size());
    CMatrixDouble S(kNumbers * m, kNumbers * m);
    S.setZero();
    for (Eigen::Index i = 0; i < m; ++i)
    {
        const Eigen::Index row = problem.rows[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < m; ++j)
            S.asEigen().block<2, 2>(kNumbers * i, kNumbers * j) =
                problem.prediction->HPHt.block<2, 2>(2 * row,
                                                     2 * problem.rows[static_cast<std::size_t>(j)]);
        S.asEigen().block<2, 2>(kNumbers * i, kNumbers * i) +=
            problem.candidates[static_cast<std::size_t>(i)].front().R;
        S(kNumbers * i + 2, kNumbers * i + 2) = 1.0;
    }
    return S;
}

MrptProblem translate(const AssociationProblem& problem)
{
    MrptProblem mrpt{CMatrixDouble(static_cast<Eigen::Index>(problem.rows.size()), kNumbers),
                     covarianceOf(problem),
                     CMatrixDouble(),
                     {}};
    std::vector<Eigen::Vector3d> pixels;
    for (std::size_t i = 0; i < problem.rows.size(); ++i)
    {
        const double number = kNumberStep * static_cast<double>(i);
        const auto& h = problem.prediction->rows[static_cast<std::size_t>(problem.rows[i])].h;
        mrpt.Y.asEigen().row(static_cast<Eigen::Index>(i)) << h.transpose(), number;
        for (std::size_t c = 0; c < problem.candidates[i].size(); ++c)
        {
            const Eigen::Vector2d& z = problem.candidates[i][c].z;
            pixels.emplace_back(z.x(), z.y(), number);
            mrpt.pixels.emplace_back(i, static_cast<int>(c));
        }
    }
    mrpt.Z.resize(static_cast<Eigen::Index>(pixels.size()), kNumbers);
    for (std::size_t j = 0; j < pixels.size(); ++j)
        mrpt.Z.asEigen().row(static_cast<Eigen::Index>(j)) = pixels[j].transpose();
    return mrpt;
}

/** \param answer  candidate of each landmark, 0 = none, 1 = the first; then the nodes */
void solve(const MrptProblem& problem, double tau, SharedNumbers& answer)
{
    mrpt::slam::TDataAssociationResults results;
    // Not by the kd-tree, which loses compatible pairs where covariances differ.
    mrpt::slam::data_association_full_covariance(problem.Z, problem.Y, problem.S, results,
                                                 mrpt::slam::assocJCBB, mrpt::slam::metricMaha,
                                                 quantileOfThree(tau), false);
    for (const auto& [pixel, landmark] : results.associations)
        answer[landmark] = 1 + problem.pixels[pixel].second;
    answer[answer.size() - 1] = static_cast<long>(results.nNodesExploredInJCBB);
}
}  // namespace

JcbbMrpt::JcbbMrpt(const BatchOptions& batch, ConfigSection section)
    : BatchAssociator(batch), tau_(section.get("tau", 0.95, {1e-6, 1.0 - 1e-12}))
{
    maxCandidates_ = section.get("max_candidates", maxCandidates_, {1.0, 100.0});
    cap_ms_ = 1e3 * section.get("time_cap_s", 1e-3 * cap_ms_, {0.0, 1e5});
    section.rejectUnknownKeys();
}

AssociatorTraits JcbbMrpt::traits() const
{
    AssociatorTraits t;
    t.spatial = true;
    t.multipleCandidates = maxCandidates_ > 1;
    t.hypothesesWithinFrame = true;
    return t;
}

std::vector<int> JcbbMrpt::nearest(const AssociationProblem& problem) const
{
    std::vector<int> chosen(problem.rows.size(), -1);
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
        const Eigen::Index row = problem.rows[i];
        const Eigen::Matrix2d S = problem.prediction->HPHt.block<2, 2>(2 * row, 2 * row) +
                                  problem.candidates[i].front().R;
        double least = chi2Limit(2, tau_);
        for (std::size_t c = 0; c < problem.candidates[i].size(); ++c)
        {
            const Eigen::Vector2d nu = problem.candidates[i][c].z -
                                       problem.prediction->rows[static_cast<std::size_t>(row)].h;
            const double nis = nu.dot(S.inverse() * nu);
            if (!(nis < least)) continue;
            least = nis;
            chosen[i] = static_cast<int>(c);
        }
    }
    return chosen;
}

std::vector<int> JcbbMrpt::select(const AssociationProblem& problem,
                                  AssociationCounters& counters) const
{
    const MrptProblem mrpt = translate(problem);
    SharedNumbers answer(problem.rows.size() + 1);
    // With one candidate each MRPT's bound holds: as many nodes as landmarks.
    ChildRun run{cap_ms_ == 0.0 || mrpt.pixels.size() == problem.rows.size(), 0.0};
    const double left_ms = cap_ms_ - counters.otherThreadsMs;  // the frame's earlier searches
    if (run.finished)
        solve(mrpt, tau_, answer);
    else if (left_ms > 0.0)
        run = runInChild(left_ms, [&] { solve(mrpt, tau_, answer); });
    counters.selectMs += run.cpu_ms;
    counters.otherThreadsMs += run.cpu_ms;
    if (!run.finished)
    {
        ++counters.capped;
        counters.provedOptimal = false;
        return nearest(problem);
    }
    counters.nodes += answer[problem.rows.size()];
    std::vector<int> chosen;
    for (std::size_t i = 0; i < problem.rows.size(); ++i)
        chosen.push_back(static_cast<int>(answer[i]) - 1);
    return chosen;
}
}  // namespace monoslam
