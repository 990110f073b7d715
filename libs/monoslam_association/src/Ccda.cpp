// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/BatchAssociator.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_association/maximumClique.h"
#include "monoslam_support/ConfigSection.h"
#include "strategies.h"

namespace monoslam
{
namespace
{
/** Combined constraint data association: the maximum clique of the graph whose vertices are
 *  landmark and candidate, whose edges join two that are compatible with each other. A single camera
 *  has no relation of two pixels that is free of its pose: the joint D2 of the two, four dimensions,
 *  takes its place.
 *  \see Bailey, "Mobile robot localisation and mapping in extensive outdoor environments", 2002 */
class Ccda : public BatchAssociator
{
   public:
    Ccda(const BatchOptions& batch, ConfigSection section) : BatchAssociator(batch)
    {
        const double tau = section.get("tau", 0.95, {1e-6, 1.0 - 1e-12});
        single_ = chi2Limit(2, tau);
        pair_ = chi2Limit(4, tau);
        maxCandidates_ = section.get("max_candidates", maxCandidates_, {1.0, 100.0});
        nodeCap_ = section.get("node_cap", nodeCap_, {1.0, 1e9});
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
    struct Vertex
    {
        std::size_t landmark = 0;
        int candidate = 0;
        Eigen::Vector2d z;
        JointPair pair;
    };

    [[nodiscard]] int maxCandidates() const override { return maxCandidates_; }
    [[nodiscard]] bool validatesJointly() const override { return true; }

    /** Pairs that are plausible by themselves. */
    [[nodiscard]] std::vector<Vertex> listVertices(const AssociationProblem& problem,
                                                   IncrementalD2& d2) const
    {
        std::vector<Vertex> vertices;
        for (std::size_t i = 0; i < problem.rows.size(); ++i)
        {
            const Eigen::Index row = problem.rows[i];
            const auto& h = problem.prediction->rows[static_cast<std::size_t>(row)].h;
            for (std::size_t c = 0; c < problem.candidates[i].size(); ++c)
            {
                const Candidate& candidate = problem.candidates[i][c];
                const JointPair pair{row, candidate.z - h, candidate.R};
                if (!d2.push(pair)) continue;
                if (d2.d2() <= single_)
                    vertices.push_back({i, static_cast<int>(c), candidate.z, pair});
                d2.pop();
            }
        }
        return vertices;
    }

    [[nodiscard]] std::vector<int> select(const AssociationProblem& problem,
                                          AssociationCounters& counters) const override
    {
        IncrementalD2 d2(problem.prediction->HPHt, 2);
        const std::vector<Vertex> vertices = listVertices(problem, d2);
        std::vector<std::vector<bool>> adjacent(vertices.size(),
                                                std::vector<bool>(vertices.size(), false));
        for (std::size_t a = 0; a < vertices.size(); ++a)
        {
            if (!d2.push(vertices[a].pair)) continue;
            for (std::size_t b = 0; b < a; ++b)
            {
                if (vertices[a].landmark == vertices[b].landmark || vertices[a].z == vertices[b].z)
                    continue;
                ++counters.d2Evaluations;
                if (!d2.push(vertices[b].pair)) continue;
                adjacent[a][b] = adjacent[b][a] = d2.d2() <= pair_;
                d2.pop();
            }
            d2.pop();
        }
        const CliqueResult clique = maximumClique(adjacent, nodeCap_);
        counters.nodes += clique.nodes;
        counters.jointSearches += 1;
        counters.provedOptimal = counters.provedOptimal && clique.proved;
        std::vector<int> chosen(problem.rows.size(), -1);
        for (const std::size_t v : clique.vertices)
            chosen[vertices[v].landmark] = vertices[v].candidate;
        return chosen;
    }

    double single_;
    double pair_;
    int maxCandidates_ = 3;
    int nodeCap_ = 20000;
};
}  // namespace

std::unique_ptr<Associator> makeCcda(const IniFile& file, const std::string& fileName)
{
    return std::make_unique<Ccda>(BatchOptions::from(file, fileName),
                                  ConfigSection(file, "association.ccda", fileName));
}
}  // namespace monoslam
