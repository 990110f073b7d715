// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "subsetProblems.h"

namespace monoslam::test
{
namespace
{
constexpr SubsetSearch kExact[] = {SubsetSearch::Printed,        SubsetSearch::Downdate,
                                   SubsetSearch::BranchAndBound, SubsetSearch::Removal,
                                   SubsetSearch::Reinsertion,    SubsetSearch::Automatic};
const SubsetBudget kUnlimited{1e12, 1000000000};
const Chi2Table kTable(0.95, 100);
}  // namespace

TEST(Chi2Limit, MatchesPrintedQuantiles)
{
    EXPECT_NEAR(chi2Limit(2, 0.95), 5.9915, 5e-5);
    EXPECT_NEAR(chi2Limit(2, 0.99), 9.2103, 5e-5);
    EXPECT_NEAR(chi2Limit(40, 0.95), 55.7585, 5e-5);
    EXPECT_EQ(chi2Limit(0, 0.95), 0.0);
    EXPECT_TRUE(std::isinf(chi2Limit(2, 1.0)));
    EXPECT_EQ(kTable(100), chi2Limit(100, 0.95));
    EXPECT_EQ(kTable(102), chi2Limit(102, 0.95));
}

TEST(IncrementalD2, EqualsTheDenseFormAndNeverFalls)
{
    std::mt19937 rng(1);
    for (int run = 0; run < 200; ++run)
    {
        const SubsetProblem problem = randomProblem(12, 2, kTable, rng);
        IncrementalD2 stack(problem.S, 12);
        unsigned kept = 0;
        for (Eigen::Index j = 11; j >= 0; --j)
        {
            const double before = stack.d2();
            ASSERT_TRUE(stack.push({j, problem.nu.segment<2>(2 * j)}));
            EXPECT_GE(stack.d2(), before);
            if (j % 3 == 1) stack.pop();
            if (j % 3 == 1) continue;
            kept |= 1U << j;
            EXPECT_NEAR(stack.d2(), denseD2(problem, kept), 1e-9 * (1.0 + stack.d2()));
        }
    }
}

TEST(IncrementalD2, RefusesAPairThatMakesSSingular)
{
    const Eigen::MatrixXd S = Eigen::MatrixXd::Ones(4, 4) + Eigen::MatrixXd::Identity(4, 4);
    IncrementalD2 stack(S, 2);
    ASSERT_TRUE(stack.push({0, {1.0, 2.0}}));
    const double before = stack.d2();
    EXPECT_FALSE(stack.push({0, {1.0, 2.0}}));
    EXPECT_EQ(stack.d2(), before);
    EXPECT_EQ(stack.pairs(), 1);
}

TEST(DowndatingD2, EqualsTheDenseFormAfterRemovals)
{
    std::mt19937 rng(2);
    for (int run = 0; run < 200; ++run)
    {
        const SubsetProblem problem = randomProblem(10, 3, kTable, rng);
        DowndatingD2 whole(problem.S, problem.nu);
        unsigned kept = (1U << 10) - 1;
        for (const Eigen::Index j : {4, 0, 9})
        {
            const double w = whole.conditionalNis(j);
            kept &= ~(1U << j);
            whole.remove(j);
            EXPECT_NEAR(whole.d2(), denseD2(problem, kept), 1e-9 * (1.0 + w + whole.d2()));
        }
        EXPECT_NE(whole.worst(), 4);
    }
}

TEST(LargestCompatibleSubset, SolvesTheGoldenExamples)
{
    const SubsetProblem first = goldenProblem(kTable);
    const SubsetProblem second = secondGoldenProblem(kTable);
    EXPECT_NEAR(denseD2(first, 31), 25.584211, 1e-6);
    EXPECT_NEAR(denseD2(second, 255), 98.933415, 1e-6);
    for (const SubsetSearch search : kExact)
    {
        const SubsetResult one = largestCompatibleSubset(first, search, kUnlimited);
        EXPECT_EQ(one.removed, std::vector<Eigen::Index>{3});
        EXPECT_NEAR(one.d2, 2.119368, 1e-6);
        const SubsetResult two = largestCompatibleSubset(second, search, kUnlimited);
        EXPECT_EQ(two.removed, (std::vector<Eigen::Index>{2, 6}));
        EXPECT_NEAR(two.d2, 5.443261, 1e-6);
    }
    const SubsetResult printed = largestCompatibleSubset(first, SubsetSearch::Printed);
    EXPECT_EQ(printed.leaves, 5);
    EXPECT_EQ(printed.nodes, 6);
}

TEST(LargestCompatibleSubset, EqualsBruteForceWhateverTheSearch)
{
    std::mt19937 rng(3);
    long searched = 0;
    for (int run = 0; run < 1000; ++run)
    {
        const Eigen::Index m = 3 + run % 6;
        const SubsetProblem problem = randomProblem(m, run % 4, kTable, rng);
        const SubsetResult truth = bruteForce(problem);
        for (const SubsetSearch search : kExact)
        {
            const SubsetResult result = largestCompatibleSubset(problem, search, kUnlimited);
            ASSERT_TRUE(result.proved);
            ASSERT_EQ(result.removed, truth.removed) << "run " << run;
            ASSERT_NEAR(result.d2, truth.d2, 1e-9 * (1.0 + denseD2(problem, (1U << m) - 1)));
            searched += result.searched ? 1 : 0;
        }
    }
    EXPECT_GT(searched, 1000);
}

TEST(LargestCompatibleSubset, CountsNodesAsTheRecursionBuildsThem)
{
    std::mt19937 rng(4);
    for (int run = 0; run < 200; ++run)
    {
        const Eigen::Index m = 5 + run % 5;
        const SubsetProblem problem = randomProblem(m, 1 + run % 3, kTable, rng);
        const SubsetResult printed = largestCompatibleSubset(problem, SubsetSearch::Printed);
        double leaves = 0.0, nodes = 0.0;
        for (std::size_t i = 1; i <= printed.removed.size(); ++i)
        {
            leaves += binomial(m, i);
            nodes += binomial(m + 1, i);
        }
        ASSERT_LT(printed.removed.size(), static_cast<std::size_t>(m));
        EXPECT_EQ(static_cast<double>(printed.leaves), leaves);
        EXPECT_EQ(static_cast<double>(printed.nodes), nodes);
    }
}

TEST(LargestCompatibleSubset, SaysSoWhenTheBudgetEnds)
{
    std::mt19937 rng(5);
    const SubsetProblem problem = randomProblem(30, 8, kTable, rng);
    const SubsetResult greedy = largestCompatibleSubset(problem, SubsetSearch::Greedy);
    for (const SubsetSearch search : kExact)
    {
        const SubsetResult result = largestCompatibleSubset(problem, search, {10.0, 10});
        EXPECT_TRUE(result.searched);
        EXPECT_FALSE(result.proved);
        EXPECT_LE(result.removed.size(), greedy.removed.size());
        EXPECT_LE(result.d2, problem.limits[result.removed.size()]);
    }
}

TEST(JointBranchAndBound, CountsTheGoldenNodes)
{
    const SubsetProblem golden = goldenProblem(kTable);
    const JcbbResult bounded = jointBranchAndBound(jcbbProblem(golden), kTable, {true, 1000});
    const JcbbResult unbounded = jointBranchAndBound(jcbbProblem(golden), kTable, {false, 1000});
    EXPECT_EQ(bounded.chosen, (std::vector<int>{0, 0, 0, -1, 0}));
    EXPECT_EQ(bounded.chosen, unbounded.chosen);
    EXPECT_NEAR(bounded.d2, 2.119368, 1e-6);
    EXPECT_EQ(bounded.nodes, 12);
    EXPECT_EQ(unbounded.nodes, 42);
    EXPECT_EQ(unbounded.leaves, 18);
}

TEST(JointBranchAndBound, IsNeverLargerThanHohctAndItsBoundLosesNothing)
{
    std::mt19937 rng(6);
    for (int run = 0; run < 1000; ++run)
    {
        const Eigen::Index m = 3 + run % 7;
        const SubsetProblem problem = randomProblem(m, run % 4, kTable, rng);
        const auto exact = largestCompatibleSubset(problem, SubsetSearch::Automatic, kUnlimited);
        const JcbbResult bounded =
            jointBranchAndBound(jcbbProblem(problem), kTable, {true, 1000000});
        const JcbbResult whole =
            jointBranchAndBound(jcbbProblem(problem), kTable, {false, 1000000});
        EXPECT_EQ(bounded.chosen, whole.chosen);
        EXPECT_LE(pairsOf(bounded), static_cast<std::size_t>(m) - exact.removed.size());
    }
}

TEST(JointBranchAndBound, ChoosesAmongCandidatesAndNeverSharesAPixel)
{
    const Eigen::MatrixXd HPHt = 25.0 * Eigen::MatrixXd::Ones(4, 4);
    const Eigen::Matrix2d R = Eigen::Matrix2d::Identity();
    JcbbProblem problem{&HPHt, {}, {}};
    problem.pairs = {{{0, {0.0, 0.0}, R}, {0, {5.0, 5.0}, R}}, {{1, {5.0, 5.0}, R}}};
    problem.pixels = {{{0.0, 0.0}, {5.0, 5.0}}, {{5.0, 5.0}}};
    EXPECT_EQ(jointBranchAndBound(problem, kTable, {}).chosen, (std::vector<int>{0, -1}));
    problem.pixels[1][0] = {100.0, 5.0};
    EXPECT_EQ(jointBranchAndBound(problem, kTable, {}).chosen, (std::vector<int>{1, 0}));
}
}  // namespace monoslam::test
