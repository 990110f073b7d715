// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/largestCompatibleAssignment.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "assignmentProblems.h"
#include "monoslam_association/ConditionalPairs.h"
#include "monoslam_association/assignByJcbb.h"
#include "monoslam_association/assignNearest.h"

namespace monoslam::test
{
namespace
{
constexpr long kNoCap = 1000000000;

AssignmentProblem smallProblem(int run, std::mt19937& rng)
{
    const int predictions = 3 + run % 4;
    const AssignmentShape shape{run % 3 + 1, predictions, std::min(3 + run % 3, predictions),
                                run % 4,     0.99,        run % 5 == 0};
    return randomAssignment(shape, rng);
}

/** Of an assignment's own D2, with the rounding of the largest D2 that was summed on the way. */
void expectDistance(const AssignmentProblem& problem, const AssignmentResult& result)
{
    AssignmentResult dense = result;
    measureDensely(problem, dense);
    EXPECT_EQ(result.pairs, dense.pairs);
    EXPECT_NEAR(result.d2, dense.d2, 1e-9 * (1.0 + dense.d2));
    EXPECT_NEAR(result.logDet, dense.logDet, 1e-9 * (1.0 + std::abs(dense.logDet)));
}
}  // namespace

TEST(ConditionalPairs, EqualTheDenseFormWhileTheStackGrowsAndShrinks)
{
    std::mt19937 rng(1);
    for (int run = 0; run < 200; ++run)
    {
        AssignmentShape shape{run % 3 + 1, 6, 6, 1, 1.0, run % 2 == 0};
        const AssignmentProblem problem = randomAssignment(shape, rng);
        ConditionalPairs stack(problem);
        AssignmentResult kept;
        kept.chosen.assign(6, -1);
        for (std::size_t i = 0; i < 6; ++i)
        {
            const AssignmentPair& pair = problem.items[i][i];
            const double before = stack.d2(), logDet = stack.logDet();
            const ConditionalPairs::Gain gain = stack.gain(pair);
            ASSERT_TRUE(stack.push(pair));
            EXPECT_NEAR(stack.d2(), before + gain.nis, 1e-9 * (1.0 + stack.d2()));
            EXPECT_NEAR(stack.logDet(), logDet + gain.logDet, 1e-9);
            if (i % 3 == 1) stack.pop();
            if (i % 3 == 1) continue;
            kept.chosen[i] = static_cast<int>(i);
            kept.d2 = stack.d2();
            kept.logDet = stack.logDet();
            kept.pairs = stack.pairs();
            expectDistance(problem, kept);
        }
    }
}

TEST(ConditionalPairs, RefuseWhatHasNoDistance)
{
    AssignmentProblem problem{2, Eigen::MatrixXd::Zero(2, 2), {{}}, {0.0, 6.0}};
    problem.items[0] = {{0, 0, Eigen::Vector2d(1.0, 0.0), {}}};
    ConditionalPairs stack(problem);
    EXPECT_FALSE(stack.push(problem.items[0][0]));
    EXPECT_TRUE(std::isinf(stack.gain(problem.items[0][0]).nis));
    EXPECT_EQ(largestCompatibleAssignment(problem, kNoCap).pairs, 0);
    problem.items[0][0].nu = Eigen::Vector3d::Zero();
    EXPECT_THROW(ConditionalPairs{problem}, std::invalid_argument);
}

TEST(LargestCompatibleAssignment, EqualsBruteForceOnAThousandProblems)
{
    std::mt19937 rng(2);
    long several = 0, removals = 0;
    for (int run = 0; run < 1000; ++run)
    {
        AssignmentProblem problem = smallProblem(run, rng);
        for (const bool likelihood : {false, true})
        {
            problem.likelihood = likelihood;
            const AssignmentResult truth = EveryAssignment(problem).best();
            const AssignmentResult result = largestCompatibleAssignment(problem, kNoCap);
            ASSERT_TRUE(result.proved);
            ASSERT_EQ(result.chosen, truth.chosen) << "run " << run;
            ASSERT_NEAR(result.d2, truth.d2, 1e-9 * (1.0 + truth.d2));
            expectDistance(problem, result);
            removals += static_cast<long>(problem.items.size()) - result.pairs;
        }
        for (const auto& item : problem.items) several += item.size() > 1 ? 1 : 0;
    }
    EXPECT_GT(several, 1000);
    EXPECT_GT(removals, 1000);
}

TEST(LargestCompatibleAssignment, IsNeverSmallerThanJcbbAndSometimesLarger)
{
    std::mt19937 rng(3);
    long larger = 0;
    for (int run = 0; run < 300; ++run)
    {
        const AssignmentProblem problem =
            randomAssignment({2 + run % 2, 10, 8, run % 4, 0.99, false}, rng);
        const AssignmentResult jcbb = assignByJcbb(problem, kNoCap);
        const AssignmentResult exact = largestCompatibleAssignment(problem, kNoCap);
        expectDistance(problem, jcbb);
        ASSERT_TRUE(jcbb.proved && exact.proved);
        ASSERT_GE(exact.pairs, jcbb.pairs);
        ASSERT_TRUE(exact.pairs > jcbb.pairs || exact.d2 <= jcbb.d2 + 1e-9);
        larger += exact.pairs > jcbb.pairs ? 1 : 0;
    }
    EXPECT_GT(larger, 0);
}

TEST(LargestCompatibleAssignment, EqualsTheSubsetSearchWithOneCandidateEach)
{
    std::mt19937 rng(4);
    const Chi2Table table(0.95, 100);
    for (int run = 0; run < 300; ++run)
    {
        const Eigen::Index m = 4 + run % 9;
        const SubsetProblem subset = randomProblem(m, run % 4, table, rng);
        AssignmentProblem problem{2, subset.S, {}, {}};
        for (Eigen::Index j = 0; j < m; ++j)
            problem.items.push_back({{j, j, subset.nu.segment<2>(2 * j), {}}});
        problem.limits.assign(subset.limits.rbegin(), subset.limits.rend());
        const SubsetResult truth =
            largestCompatibleSubset(subset, SubsetSearch::BranchAndBound, {1e12, kNoCap});
        const AssignmentResult result = largestCompatibleAssignment(problem, kNoCap);
        ASSERT_EQ(result.pairs, m - static_cast<Eigen::Index>(truth.removed.size()));
        for (const Eigen::Index j : truth.removed)
            ASSERT_EQ(result.chosen[static_cast<std::size_t>(j)], -1);
        ASSERT_NEAR(result.d2, truth.d2, 1e-9 * (1.0 + denseD2(subset, (1U << m) - 1)));
    }
}

TEST(LargestCompatibleAssignment, SaysSoWhenTheCapEndsTheSearch)
{
    std::mt19937 rng(5);
    const AssignmentProblem problem = randomAssignment({3, 20, 18, 6, 0.99, false}, rng);
    const AssignmentResult result = largestCompatibleAssignment(problem, 10);
    EXPECT_FALSE(result.proved);
    EXPECT_GE(result.pairs, assignByJcbb(problem, 10).pairs);
    EXPECT_LE(result.d2, problem.limits[static_cast<std::size_t>(result.pairs)]);
}

TEST(AssignByJcbb, IsTheJcbbOfTheMonocularFilter)
{
    std::mt19937 rng(6);
    const Chi2Table table(0.95, 100);
    for (int run = 0; run < 500; ++run)
    {
        const Eigen::Index m = 3 + run % 7;
        const SubsetProblem subset = randomProblem(m, run % 4, table, rng);
        const Eigen::MatrixXd HPHt = subset.S - Eigen::MatrixXd::Identity(2 * m, 2 * m);
        JcbbProblem pixels{&HPHt, {}, {}};
        AssignmentProblem problem{2, HPHt, {}, {}};
        std::normal_distribution<double> normal(0.0, 8.0);
        for (Eigen::Index j = 0; j < m; ++j)
        {
            pixels.pairs.emplace_back();
            problem.items.emplace_back();
            for (int c = 0; c < 1 + (run + j) % 3; ++c)
            {
                const Eigen::Vector2d nu =
                    subset.nu.segment<2>(2 * j) + c * Eigen::Vector2d(normal(rng), normal(rng));
                pixels.pairs.back().push_back({j, nu, Eigen::Matrix2d::Identity()});
                problem.items.back().push_back(
                    {j, 10 * j + c, nu, Eigen::MatrixXd(Eigen::Matrix2d::Identity())});
            }
            const auto nis = [&](const JointPair& pair)
            { return pair.nu.dot(subset.S.block<2, 2>(2 * j, 2 * j).llt().solve(pair.nu)); };
            std::sort(pixels.pairs.back().begin(), pixels.pairs.back().end(),
                      [&](const JointPair& a, const JointPair& b) { return nis(a) < nis(b); });
        }
        for (Eigen::Index k = 0; k <= m; ++k) problem.limits.push_back(table(2 * k));
        const JcbbResult theirs = jointBranchAndBound(pixels, table, {true, kNoCap});
        const AssignmentResult ours = assignByJcbb(problem, kNoCap);
        ASSERT_EQ(ours.pairs, static_cast<long>(pairsOf(theirs)));
        ASSERT_EQ(ours.nodes, theirs.nodes);
        ASSERT_NEAR(ours.d2, theirs.d2, 1e-9 * (1.0 + theirs.d2));
    }
}

TEST(AssignNearest, LetsTheNearestChooseFirst)
{
    AssignmentProblem problem{2, Eigen::MatrixXd::Identity(4, 4), {}, {0.0, 6.0, 9.5}};
    const auto nu = [](double x) { return Eigen::Vector2d(x, 0.0); };
    problem.items = {{{0, 0, nu(1.0), {}}, {1, 1, nu(3.0), {}}}, {{0, 0, nu(0.5), {}}}};
    const AssignmentResult result = assignNearest(problem);
    EXPECT_EQ(result.chosen, (std::vector<int>{1, 0}));
    EXPECT_DOUBLE_EQ(result.d2, 9.25);
}
}  // namespace monoslam::test
