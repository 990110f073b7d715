// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <numeric>

#include "monoslam_association/BatchAssociator.h"
#include "monoslam_association/jointBranchAndBound.h"
#include "monoslam_support/ConfigSection.h"
#include "strategies.h"

namespace monoslam
{
namespace
{
/** Joint compatibility branch and bound, [association.jcbb]. */
class JcbbAssociator : public BatchAssociator
{
   public:
    JcbbAssociator(const BatchOptions& batch, ConfigSection section)
        : BatchAssociator(batch), limits_(section.get("tau", 0.95, {1e-6, 1.0 - 1e-12}))
    {
        options_.bound = section.get("bound", options_.bound);
        options_.node_cap =
            section.get("node_cap", static_cast<int>(options_.node_cap), {1.0, 1e9});
        maxCandidates_ = section.get("max_candidates", maxCandidates_, {1.0, 100.0});
        section.rejectUnknownKeys();
    }

    [[nodiscard]] AssociatorTraits traits() const override
    {
        AssociatorTraits t;
        t.spatial = true;
        t.multipleCandidates = getsSeveralCandidates();
        t.hypothesesWithinFrame = true;
        return t;
    }

   private:
    [[nodiscard]] bool validatesJointly() const override { return true; }
    [[nodiscard]] int maxCandidates() const override { return maxCandidates_; }
    /** Without its bound the search visits every assignment. */
    [[nodiscard]] bool choosesAmongSeveral() const override { return options_.bound; }

    /** Candidates of one landmark, nearest first by the prior's S. */
    static std::vector<int> byDistance(const AssociationProblem& problem, std::size_t i)
    {
        const Prediction& prediction = *problem.prediction;
        const Eigen::Index row = problem.rows[i];
        std::vector<double> nis;
        for (const Candidate& candidate : problem.candidates[i])
        {
            const Eigen::Matrix2d S = prediction.HPHt.block<2, 2>(2 * row, 2 * row) + candidate.R;
            const Eigen::Vector2d nu =
                candidate.z - prediction.rows[static_cast<std::size_t>(row)].h;
            nis.push_back(nu.dot(S.inverse() * nu));
        }
        std::vector<int> order(nis.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(
            order.begin(), order.end(),
            [&nis](int a, int b)
            { return nis[static_cast<std::size_t>(a)] < nis[static_cast<std::size_t>(b)]; });
        return order;
    }

    [[nodiscard]] std::vector<int> select(const AssociationProblem& problem,
                                          AssociationCounters& counters) const override
    {
        JcbbProblem joint{&problem.prediction->HPHt, {}, {}};
        std::vector<std::vector<int>> orders;
        for (std::size_t i = 0; i < problem.rows.size(); ++i)
        {
            const Eigen::Index row = problem.rows[i];
            const auto& h = problem.prediction->rows[static_cast<std::size_t>(row)].h;
            orders.push_back(byDistance(problem, i));
            joint.pairs.emplace_back();
            joint.pixels.emplace_back();
            for (const int c : orders.back())
            {
                const Candidate& candidate = problem.candidates[i][static_cast<std::size_t>(c)];
                joint.pairs.back().push_back({row, candidate.z - h, candidate.R});
                joint.pixels.back().push_back(candidate.z);
            }
        }
        const JcbbResult result = jointBranchAndBound(joint, limits_, options_);
        counters.jointSearches += result.searched ? 1 : 0;
        counters.nodes += result.nodes;
        counters.leaves += result.leaves;
        counters.d2Evaluations += result.d2Evaluations;
        counters.provedOptimal = counters.provedOptimal && result.finished;
        std::vector<int> chosen = result.chosen;
        for (std::size_t i = 0; i < chosen.size(); ++i)
            if (chosen[i] >= 0) chosen[i] = orders[i][static_cast<std::size_t>(chosen[i])];
        return chosen;
    }

    Chi2Table limits_;
    JcbbOptions options_;
    int maxCandidates_ = 1;
};
}  // namespace

std::unique_ptr<Associator> makeJcbb(const IniFile& file, const std::string& fileName)
{
    return std::make_unique<JcbbAssociator>(BatchOptions::from(file, fileName),
                                            ConfigSection(file, "association.jcbb", fileName));
}
}  // namespace monoslam
