// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <utility>

#include "monoslam_association/BatchAssociator.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_association/largestCompatibleAssignment.h"
#include "monoslam_association/largestCompatibleSubset.h"
#include "monoslam_support/ConfigSection.h"
#include "strategies.h"

namespace monoslam
{
namespace
{
/** Options of [association.hohct]. */
struct HohctOptions
{
    double tau = 0.95;
    SubsetSearch search = SubsetSearch::Automatic;
    int dofPerPair = 2;  ///< 1 is what the paper prints: right sets then fail too often
    SubsetBudget budget;
    int maxCandidates = 1;
    long assignmentNodes = 20000;  ///< cap of the search over several candidates

    static HohctOptions from(const IniFile& file, const std::string& fileName);
};

HohctOptions HohctOptions::from(const IniFile& file, const std::string& fileName)
{
    ConfigSection section(file, "association.hohct", fileName);
    HohctOptions o;
    o.tau = section.get("tau", o.tau, {1e-6, 1.0 - 1e-12});
    o.search = section.get<SubsetSearch>("search", o.search,
                                         {{"automatic", SubsetSearch::Automatic},
                                          {"printed", SubsetSearch::Printed},
                                          {"downdate", SubsetSearch::Downdate},
                                          {"branch_and_bound", SubsetSearch::BranchAndBound},
                                          {"removal", SubsetSearch::Removal},
                                          {"reinsertion", SubsetSearch::Reinsertion},
                                          {"greedy", SubsetSearch::Greedy}});
    o.dofPerPair = section.get<int>("dof", o.dofPerPair, {{"twice_pairs", 2}, {"pairs", 1}});
    o.budget.subsets = section.get("subset_cap", o.budget.subsets, {1.0, 1e12});
    o.budget.nodes = section.get("node_cap", static_cast<int>(o.budget.nodes), {1.0, 1e9});
    const double time_ms = section.get("time_cap_ms", 0.0, {0.0, 1e6});
    if (time_ms > 0.0) o.budget.time_ms = time_ms;
    o.maxCandidates = section.get("max_candidates", o.maxCandidates, {1.0, 100.0});
    o.assignmentNodes =
        section.get("assignment_node_cap", static_cast<int>(o.assignmentNodes), {1.0, 1e9});
    section.rejectUnknownKeys();
    return o;
}

/** The pairs of a frame; a pixel can be used once, whichever landmarks it looks like. */
AssignmentProblem assignmentProblem(const AssociationProblem& problem)
{
    AssignmentProblem assignment;
    assignment.HPHt = problem.prediction->HPHt;
    std::map<std::pair<double, double>, Eigen::Index> pixels;
    for (std::size_t i = 0; i < problem.rows.size(); ++i)
    {
        const Eigen::Index row = problem.rows[i];
        const auto& h = problem.prediction->rows[static_cast<std::size_t>(row)].h;
        assignment.items.emplace_back();
        for (const Candidate& candidate : problem.candidates[i])
        {
            const auto next = static_cast<Eigen::Index>(pixels.size());
            const auto use = pixels.emplace(std::pair(candidate.z.x(), candidate.z.y()), next);
            assignment.items.back().push_back(
                {row, use.first->second, candidate.z - h, candidate.R});
        }
    }
    return assignment;
}

/** Highest-order hypothesis compatibility test: the largest jointly compatible subset. */
class Hohct : public BatchAssociator
{
   public:
    Hohct(const BatchOptions& batch, const HohctOptions& options)
        : BatchAssociator(batch), options_(options), limits_(options.tau)
    {
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
    [[nodiscard]] int maxCandidates() const override { return options_.maxCandidates; }
    [[nodiscard]] bool choosesAmongSeveral() const override { return true; }

    [[nodiscard]] std::vector<int> select(const AssociationProblem& problem,
                                          AssociationCounters& counters) const override
    {
        const bool several =
            std::any_of(problem.candidates.begin(), problem.candidates.end(),
                        [](const std::vector<Candidate>& of) { return of.size() > 1; });
        return several ? selectAmongSeveral(problem, counters) : selectSubset(problem, counters);
    }

    [[nodiscard]] std::vector<int> selectAmongSeveral(const AssociationProblem& problem,
                                                      AssociationCounters& counters) const
    {
        AssignmentProblem assignment = assignmentProblem(problem);
        const auto items = static_cast<Eigen::Index>(assignment.items.size());
        for (Eigen::Index kept = 0; kept <= items; ++kept)
            assignment.limits.push_back(limits_(options_.dofPerPair * kept));
        const AssignmentResult result =
            largestCompatibleAssignment(assignment, options_.assignmentNodes);
        counters.jointSearches += result.pairs < items ? 1 : 0;
        counters.nodes += result.nodes;
        counters.provedOptimal = counters.provedOptimal && result.proved;
        return result.chosen;
    }

    [[nodiscard]] std::vector<int> selectSubset(const AssociationProblem& problem,
                                                AssociationCounters& counters) const
    {
        std::vector<PixelMeasurement> pixels;
        for (std::size_t i = 0; i < problem.rows.size(); ++i)
        {
            const Candidate& candidate = problem.candidates[i].front();
            pixels.push_back({problem.rows[i], candidate.z, candidate.R});
        }
        JointInnovation joint = stackInnovation(*problem.prediction, pixels);
        SubsetProblem subset{std::move(joint.S), std::move(joint.nu), {}};
        for (Eigen::Index kept = subset.pairs(); kept >= 0; --kept)
            subset.limits.push_back(limits_(options_.dofPerPair * kept));
        const SubsetResult result =
            largestCompatibleSubset(subset, options_.search, options_.budget);

        counters.jointSearches += result.searched ? 1 : 0;
        counters.faults += result.valid ? 0 : 1;
        counters.nodes += result.nodes;
        counters.leaves += result.leaves;
        counters.d2Evaluations += result.d2Evaluations;
        counters.provedOptimal = counters.provedOptimal && result.proved;
        std::vector<int> chosen(problem.rows.size(), 0);
        for (const Eigen::Index j : result.removed) chosen[static_cast<std::size_t>(j)] = -1;
        return chosen;
    }

    HohctOptions options_;
    Chi2Table limits_;
};
}  // namespace

std::unique_ptr<Associator> makeHohct(const IniFile& file, const std::string& fileName)
{
    return std::make_unique<Hohct>(BatchOptions::from(file, fileName),
                                   HohctOptions::from(file, fileName));
}
}  // namespace monoslam
