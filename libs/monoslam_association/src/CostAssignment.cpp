// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "monoslam_association/BatchAssociator.h"
#include "monoslam_association/CandidateLikelihood.h"
#include "monoslam_association/leastCostAssignment.h"
#include "monoslam_support/ConfigSection.h"
#include "strategies.h"

namespace monoslam
{
namespace
{
/** Association of least cost, -2 ln l of every landmark's candidate or miss (CandidateLikelihood),
 *  no pixel taken twice: stands in for the expected-cost association of decision theory.
 *  \see Kwok, Ha, Fang, "Data association in bearing-only SLAM using a cost function-based
 *       approach", ICRA 2007 */
class CostAssignment : public BatchAssociator
{
   public:
    CostAssignment(const BatchOptions& batch, ConfigSection section)
        : BatchAssociator(batch), options_(LikelihoodOptions::from(section))
    {
        section.rejectUnknownKeys();
    }

    [[nodiscard]] AssociatorTraits traits() const override
    {
        AssociatorTraits t;
        t.spatial = t.appearance = true;
        t.multipleCandidates = options_.max_candidates > 1;
        t.hypothesesWithinFrame = false;
        return t;
    }

   private:
    [[nodiscard]] int maxCandidates() const override { return options_.max_candidates; }
    [[nodiscard]] std::optional<double> minScore() const override { return options_.min_zncc; }

    [[nodiscard]] std::vector<int> select(const AssociationProblem& problem,
                                          AssociationCounters& counters) const override
    {
        const CandidateLikelihood likelihood(options_, problem.imageArea_px2);
        const auto n = static_cast<Eigen::Index>(problem.rows.size());
        const std::vector<Eigen::Vector2d> pixels = distinctPixels(problem);
        const auto m = static_cast<Eigen::Index>(pixels.size());
        Eigen::MatrixXd cost = Eigen::MatrixXd::Constant(n, m + n, kForbidden);
        for (Eigen::Index i = 0; i < n; ++i)
        {
            // As predicted for the search: the second stage's gates know the first.
            const auto entry = static_cast<std::size_t>(i);
            PredictedLandmark row =
                problem.prediction->rows[static_cast<std::size_t>(problem.rows[entry])];
            row.h = problem.regions[entry].centre;
            row.S = problem.regions[entry].S;
            for (const Candidate& candidate : problem.candidates[entry])
            {
                const auto at = std::find(pixels.begin(), pixels.end(), candidate.z);
                cost(i, at - pixels.begin()) = -2.0 * likelihood.logFound(row, candidate);
                ++counters.d2Evaluations;
            }
            cost(i, m + i) = -2.0 * likelihood.logMissed();
        }
        const auto columns = leastCostAssignment(cost);
        std::vector<int> chosen(problem.rows.size(), -1);
        for (std::size_t i = 0; i < chosen.size(); ++i)
            if (columns[i] < m) chosen[i] = candidateAt(problem, i, pixels, columns[i]);
        return chosen;
    }

    static constexpr double kForbidden = 1e9;

    static std::vector<Eigen::Vector2d> distinctPixels(const AssociationProblem& problem)
    {
        std::vector<Eigen::Vector2d> pixels;
        for (const auto& candidates : problem.candidates)
            for (const Candidate& candidate : candidates)
                if (std::find(pixels.begin(), pixels.end(), candidate.z) == pixels.end())
                    pixels.push_back(candidate.z);
        return pixels;
    }

    static int candidateAt(const AssociationProblem& problem, std::size_t i,
                           const std::vector<Eigen::Vector2d>& pixels, Eigen::Index column)
    {
        const auto& candidates = problem.candidates[i];
        const auto at =
            std::find_if(candidates.begin(), candidates.end(),
                         [&](const Candidate& candidate)
                         { return candidate.z == pixels[static_cast<std::size_t>(column)]; });
        return static_cast<int>(at - candidates.begin());
    }

    LikelihoodOptions options_;
};
}  // namespace

std::unique_ptr<Associator> makeCostAssignment(const IniFile& file, const std::string& fileName)
{
    return std::make_unique<CostAssignment>(
        BatchOptions::from(file, fileName),
        ConfigSection(file, "association.cost_assignment", fileName));
}
}  // namespace monoslam
