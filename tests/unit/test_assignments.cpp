// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "associatorRuns.h"
#include "monoslam_association/leastCostAssignment.h"
#include "monoslam_association/maximumClique.h"
#include "randomValues.h"

namespace monoslam::test
{
namespace
{
using Graph = std::vector<std::vector<bool>>;

Graph randomGraph(std::size_t n, double density, std::mt19937& rng)
{
    Graph graph(n, std::vector<bool>(n, false));
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < a; ++b)
            graph[a][b] = graph[b][a] = uniform(rng, 0.0, 1.0) < density;
    return graph;
}

bool isClique(const Graph& graph, const std::vector<std::size_t>& vertices)
{
    for (const std::size_t a : vertices)
        for (const std::size_t b : vertices)
            if (a != b && !graph[a][b]) return false;
    return true;
}

std::size_t largestByBruteForce(const Graph& graph)
{
    std::size_t largest = 0;
    for (unsigned set = 0; set < 1U << graph.size(); ++set)
    {
        std::vector<std::size_t> vertices;
        for (std::size_t v = 0; v < graph.size(); ++v)
            if (set >> v & 1U) vertices.push_back(v);
        if (vertices.size() > largest && isClique(graph, vertices)) largest = vertices.size();
    }
    return largest;
}

double leastByBruteForce(const Eigen::MatrixXd& cost)
{
    std::vector<Eigen::Index> columns(static_cast<std::size_t>(cost.cols()));
    std::iota(columns.begin(), columns.end(), 0);
    double least = std::numeric_limits<double>::infinity();
    do
    {
        double sum = 0.0;
        for (Eigen::Index i = 0; i < cost.rows(); ++i)
            sum += cost(i, columns[static_cast<std::size_t>(i)]);
        least = std::min(least, sum);
    } while (std::next_permutation(columns.begin(), columns.end()));
    return least;
}
}  // namespace

TEST(MaximumClique, IsAsLargeAsAnyOfAllSubsets)
{
    std::mt19937 rng(1);
    for (int i = 0; i < 200; ++i)
    {
        const Graph graph =
            randomGraph(static_cast<std::size_t>(i % 13), uniform(rng, 0.1, 0.95), rng);
        const CliqueResult clique = maximumClique(graph, 1000000);
        EXPECT_TRUE(clique.proved);
        EXPECT_TRUE(isClique(graph, clique.vertices));
        EXPECT_EQ(clique.vertices.size(), largestByBruteForce(graph)) << i;
    }
}

TEST(MaximumClique, SaysWhenTheCapEndedIt)
{
    std::mt19937 rng(2);
    const Graph graph = randomGraph(60, 0.8, rng);
    const CliqueResult capped = maximumClique(graph, 3);
    EXPECT_FALSE(capped.proved);
    EXPECT_TRUE(isClique(graph, capped.vertices));
    EXPECT_GT(capped.vertices.size(), 5);  // the greedy one at least
    EXPECT_LE(capped.vertices.size(), maximumClique(graph, 10000000).vertices.size());
}

TEST(LeastCostAssignment, CostsAsLittleAsTheBestOfAllPermutations)
{
    std::mt19937 rng(3);
    for (int i = 0; i < 300; ++i)
    {
        const Eigen::Index rows = i % 6, columns = rows + i % 3;
        const Eigen::MatrixXd cost = Eigen::MatrixXd::NullaryExpr(
            rows, columns, [&]() { return uniform(rng, -10.0, 10.0); });
        const auto assigned = leastCostAssignment(cost);
        ASSERT_EQ(static_cast<Eigen::Index>(assigned.size()), rows);
        std::vector<Eigen::Index> sorted = assigned;
        std::sort(sorted.begin(), sorted.end());
        EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
        double sum = 0.0;
        for (Eigen::Index row = 0; row < rows; ++row)
            sum += cost(row, assigned[static_cast<std::size_t>(row)]);
        EXPECT_NEAR(sum, rows == 0 ? 0.0 : leastByBruteForce(cost), 1e-9);
    }
    EXPECT_THROW(static_cast<void>(leastCostAssignment(Eigen::MatrixXd::Zero(3, 2))),
                 std::invalid_argument);
}

TEST(Ccda, LeavesOutWhatIsIncompatibleWithMost)
{
    LinearWorld world = LinearWorld::withLandmarks(30, 10);
    for (const LandmarkId id : {2, 9, 17, 28}) world.displace(id, {-12.0, 12.0});
    const std::string ini = "first_stage_landmarks = 0\nfinal_gate_probability = 1\n";
    const Correction correction = run("ccda", world, ini);
    for (const LandmarkId id : {2, 9, 17, 28})
        EXPECT_EQ(recordOf(correction, id).fate, Fate::Rejected);
    EXPECT_TRUE(correction.counters.provedOptimal);
    const Correction capped = run("ccda", world, ini + "[association.ccda]\nnode_cap = 1");
    EXPECT_FALSE(capped.counters.provedOptimal);
    EXPECT_LE(count(capped, Fate::Matched), count(correction, Fate::Matched));
}

TEST(CostAssignment, GivesASharedPixelToWhomItSuitsBest)
{
    LinearWorld world = LinearWorld::withLandmarks(2, 9, 2.0);
    world.belief.x.segment<2>(world.belief.landmarks[1].offset) =
        world.belief.x.segment<2>(world.belief.landmarks[0].offset) + Eigen::Vector2d(4.0, 0.0);
    const Eigen::Vector2d h = world.predict(world.belief).rows[0].h;
    const Candidate shared{h + Eigen::Vector2d(1.0, 0.0), 0.9, world.R()};
    const Candidate other{h + Eigen::Vector2d(7.0, 0.0), 0.9, world.R()};
    world.seen[0] = {shared};
    world.seen[1] = {shared, other};
    const Correction correction = run("cost_assignment", world, "first_stage_landmarks = 0");
    EXPECT_EQ(recordOf(correction, 0).fate, Fate::Matched);
    EXPECT_EQ(recordOf(correction, 0).z, shared.z);
    EXPECT_EQ(recordOf(correction, 1).z, other.z);
}
}  // namespace monoslam::test
