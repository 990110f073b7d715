// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/registerMrptAssociators.h"

#include <mrpt/slam/data_association.h>

#include <cmath>

#include "monoslam_association/BatchAssociator.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_support/ConfigSection.h"

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

/** MRPT's JCBB on the pixels of a frame, [association.jcbb_mrpt]: the baseline of the second paper.
 *
 * It has no joint test: with one candidate each it accepts all that pass their own gate. A pixel was
 * found by the appearance of one landmark and may be paired with no other; MRPT has no word for
 * that, so landmarks and pixels get a third coordinate that keeps them apart. */
class JcbbMrpt : public BatchAssociator
{
   public:
    JcbbMrpt(const BatchOptions& batch, ConfigSection section)
        : BatchAssociator(batch), tau_(section.get("tau", 0.95, {1e-6, 1.0 - 1e-12}))
    {
        maxCandidates_ = section.get("max_candidates", maxCandidates_, {1.0, 3.0});
        section.rejectUnknownKeys();
    }

    [[nodiscard]] AssociatorTraits traits() const override
    {
        AssociatorTraits t;
        t.spatial = true;
        t.multipleCandidates = maxCandidates_ > 1;
        t.hypothesesWithinFrame = true;
        return t;
    }

   private:
    [[nodiscard]] int maxCandidates() const override { return maxCandidates_; }

    [[nodiscard]] static CMatrixDouble covarianceOf(const AssociationProblem& problem)
    {
        const auto m = static_cast<Eigen::Index>(problem.rows.size());
        CMatrixDouble S(kNumbers * m, kNumbers * m);
        S.setZero();
        for (Eigen::Index i = 0; i < m; ++i)
        {
            const Eigen::Index row = problem.rows[static_cast<std::size_t>(i)];
            for (Eigen::Index j = 0; j < m; ++j)
                S.asEigen().block<2, 2>(kNumbers * i, kNumbers * j) =
                    problem.prediction->HPHt.block<2, 2>(
                        2 * row, 2 * problem.rows[static_cast<std::size_t>(j)]);
            S.asEigen().block<2, 2>(kNumbers * i, kNumbers * i) +=
                problem.candidates[static_cast<std::size_t>(i)].front().R;
            S(kNumbers * i + 2, kNumbers * i + 2) = 1.0;
        }
        return S;
    }

    [[nodiscard]] std::vector<int> select(const AssociationProblem& problem,
                                          AssociationCounters& counters) const override
    {
        const auto m = static_cast<Eigen::Index>(problem.rows.size());
        CMatrixDouble Y(m, kNumbers);
        std::vector<Eigen::Vector3d> pixels;
        std::vector<int> candidateOf;
        for (Eigen::Index i = 0; i < m; ++i)
        {
            const auto at = static_cast<std::size_t>(i);
            const double number = kNumberStep * static_cast<double>(i);
            const auto& h = problem.prediction->rows[static_cast<std::size_t>(problem.rows[at])].h;
            Y.asEigen().row(i) << h.transpose(), number;
            for (std::size_t c = 0; c < problem.candidates[at].size(); ++c)
            {
                const Eigen::Vector2d& z = problem.candidates[at][c].z;
                pixels.emplace_back(z.x(), z.y(), number);
                candidateOf.push_back(static_cast<int>(c));
            }
        }
        CMatrixDouble Z(static_cast<Eigen::Index>(pixels.size()), kNumbers);
        for (std::size_t j = 0; j < pixels.size(); ++j)
            Z.asEigen().row(static_cast<Eigen::Index>(j)) = pixels[j].transpose();

        mrpt::slam::TDataAssociationResults results;
        // Not by the kd-tree, which loses compatible pairs where covariances differ.
        mrpt::slam::data_association_full_covariance(Z, Y, covarianceOf(problem), results,
                                                     mrpt::slam::assocJCBB, mrpt::slam::metricMaha,
                                                     quantileOfThree(tau_), false);
        counters.nodes += static_cast<long>(results.nNodesExploredInJCBB);
        std::vector<int> chosen(problem.rows.size(), -1);
        for (const auto& [pixel, landmark] : results.associations)
            chosen[landmark] = candidateOf[pixel];
        return chosen;
    }

    double tau_;
    int maxCandidates_ = 1;
};
}  // namespace

void registerMrptAssociators()
{
    registerAssociator("jcbb_mrpt",
                       [](const mrpt::config::CConfigFileBase& file, const std::string& fileName)
                       {
                           return std::make_unique<JcbbMrpt>(
                               BatchOptions::from(file, fileName),
                               ConfigSection(file, "association.jcbb_mrpt", fileName));
                       });
}
}  // namespace monoslam
