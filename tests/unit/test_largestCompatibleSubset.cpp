// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "drawnProblems.h"

namespace monoslam::test
{
namespace
{
constexpr SubsetSearch kTrees[] = {SubsetSearch::BranchAndBound, SubsetSearch::Removal,
                                   SubsetSearch::Reinsertion, SubsetSearch::Automatic};
const SubsetBudget kUnlimited{1e12, 1000000000};
const Chi2Table kTable(0.95, 200);

/** \return false if a is worse than b */
bool noWorse(const SubsetResult& a, const SubsetResult& b)
{
    if (a.removed.size() != b.removed.size()) return a.removed.size() < b.removed.size();
    return a.d2 <= b.d2 + 1e-9;
}
}  // namespace

TEST(LargestCompatibleSubset, EqualsBruteForceOnDrawnPairs)
{
    long searched = 0;
    for (unsigned seed = 0; seed < 1000; ++seed)
    {
        const Eigen::Index m = 5 + seed / 4 % 4;
        const SubsetProblem problem = drawProblem(m, 1 + seed / 16 % 3, kTable, seed);
        const SubsetResult truth = bruteForce(problem);
        const double scale = 1.0 + denseD2(problem, (1U << m) - 1);
        for (const SubsetSearch search : kTrees)
        {
            const SubsetResult result = largestCompatibleSubset(problem, search, kUnlimited);
            ASSERT_TRUE(result.proved);
            ASSERT_EQ(result.removed, truth.removed) << "seed " << seed;
            ASSERT_NEAR(result.d2, truth.d2, 1e-9 * scale);
            searched += result.searched ? 1 : 0;
        }
    }
    EXPECT_GT(searched, 1000);
}

TEST(LargestCompatibleSubset, IsTheSameWhateverTheSearchOnManyPairs)
{
    for (unsigned seed = 0; seed < 24; ++seed)
    {
        const SubsetProblem problem = drawProblem(30, 2 + seed / 4 % 4, kTable, seed);
        const SubsetResult first =
            largestCompatibleSubset(problem, SubsetSearch::Automatic, kUnlimited);
        for (const SubsetSearch search : kTrees)
        {
            const SubsetResult result = largestCompatibleSubset(problem, search, kUnlimited);
            EXPECT_TRUE(result.proved);
            EXPECT_EQ(result.removed, first.removed) << "seed " << seed;
        }
    }
}

TEST(LargestCompatibleSubset, DoesNotDependOnTheOrderOfThePairs)
{
    std::mt19937 rng(7);
    for (unsigned seed = 0; seed < 40; ++seed)
    {
        const Eigen::Index m = 20;
        const SubsetProblem problem = drawProblem(m, 3, kTable, seed);
        std::vector<Eigen::Index> order(static_cast<std::size_t>(m));
        std::iota(order.begin(), order.end(), Eigen::Index{0});
        std::shuffle(order.begin(), order.end(), rng);
        const auto at = [&order](Eigen::Index i)
        { return 2 * order[static_cast<std::size_t>(i / 2)] + i % 2; };
        SubsetProblem shuffled{Eigen::MatrixXd(2 * m, 2 * m), Eigen::VectorXd(2 * m),
                               problem.limits};
        for (Eigen::Index i = 0; i < 2 * m; ++i)
        {
            shuffled.nu(i) = problem.nu(at(i));
            for (Eigen::Index j = 0; j < 2 * m; ++j) shuffled.S(i, j) = problem.S(at(i), at(j));
        }
        for (const SubsetSearch search : kTrees)
        {
            const auto plain = largestCompatibleSubset(problem, search, kUnlimited);
            auto moved = largestCompatibleSubset(shuffled, search, kUnlimited).removed;
            for (Eigen::Index& j : moved) j = order[static_cast<std::size_t>(j)];
            std::sort(moved.begin(), moved.end());
            EXPECT_EQ(moved, plain.removed) << "seed " << seed;
        }
    }
}

TEST(LargestCompatibleSubset, NeverGetsWorseWithALargerBudget)
{
    long cut = 0;
    for (unsigned seed = 0; seed < 24; ++seed)
    {
        const SubsetProblem problem = drawProblem(40, 8, kTable, seed);
        for (const SubsetSearch search : kTrees)
        {
            SubsetResult before = largestCompatibleSubset(problem, search, {1.0, 1});
            for (long nodes = 10; nodes <= 1000000; nodes *= 10)
            {
                const auto result = largestCompatibleSubset(problem, search, {1.0, nodes});
                EXPECT_TRUE(noWorse(result, before));
                EXPECT_LE(result.d2, problem.limits[result.removed.size()]);
                EXPECT_TRUE(result.proved || !before.proved);
                EXPECT_TRUE(!before.proved || result.removed == before.removed);
                cut += result.proved ? 0 : 1;
                before = result;
            }
        }
    }
    EXPECT_GT(cut, 100);
}

TEST(LargestCompatibleSubset, ReturnsTheGreedySetUnprovedWhenThereIsNoTime)
{
    const SubsetProblem problem = drawProblem(60, 12, kTable, 3);
    const SubsetBudget noTime{1.0, 1000000000, 0.0};
    const SubsetResult greedy = largestCompatibleSubset(problem, SubsetSearch::Greedy);
    EXPECT_FALSE(greedy.proved);
    for (const SubsetSearch search : kTrees)
    {
        const SubsetResult result = largestCompatibleSubset(problem, search, noTime);
        EXPECT_FALSE(result.proved);
        EXPECT_TRUE(noWorse(result, greedy));
    }
}

TEST(LargestCompatibleSubset, RemovesAllIfNoPairIsCompatible)
{
    SubsetProblem problem = drawProblem(6, 0, kTable, 0);
    for (Eigen::Index i = 0; i < problem.nu.size(); ++i)
        problem.nu(i) = (i % 4 < 2 ? 50.0 : -50.0) * std::sqrt(problem.S(i, i));
    for (const SubsetSearch search : kTrees)
    {
        const SubsetResult result = largestCompatibleSubset(problem, search, kUnlimited);
        EXPECT_EQ(result.removed.size(), 6U);
        EXPECT_TRUE(result.proved);
        EXPECT_EQ(result.d2, 0.0);
    }
}

TEST(LargestCompatibleSubset, IsNeverSmallerThanJcbbOnDrawnPairs)
{
    long larger = 0;
    for (unsigned seed = 0; seed < 200; ++seed)
    {
        const Eigen::Index m = 8 + seed / 4 % 8;
        const SubsetProblem problem = drawProblem(m, seed / 4 % 4, kTable, seed);
        const auto exact = largestCompatibleSubset(problem, SubsetSearch::Automatic, kUnlimited);
        const JcbbResult jcbb = jointBranchAndBound(jcbbProblem(problem), kTable, {true, 1000000});
        const std::size_t kept = static_cast<std::size_t>(m) - exact.removed.size();
        EXPECT_TRUE(jcbb.finished);
        EXPECT_LE(pairsOf(jcbb), kept);
        larger += pairsOf(jcbb) < kept ? 1 : 0;
    }
    EXPECT_GT(larger, 0);
}

TEST(DrawJointPairs, KeepsEveryPairInItsGateAndItsSeed)
{
    for (unsigned seed = 0; seed < 40; ++seed)
    {
        std::mt19937 rng(seed), again(seed);
        const DrawnKind kind = kDrawnKinds[seed % 4];
        const JointPrior prior = drawJointPrior(landmarksFor(12), kind.covariance, rng);
        const JointPairs pairs = drawJointPairs(prior, {12, 3, kind.outliers}, rng);
        EXPECT_EQ(std::count(pairs.wrong.begin(), pairs.wrong.end(), 1), 3);
        for (Eigen::Index j = 0; j < 12; ++j)
        {
            const Eigen::Matrix2d S_jj = pairs.S.block<2, 2>(2 * j, 2 * j);
            const Eigen::Vector2d nu_j = pairs.nu.segment<2>(2 * j);
            EXPECT_LE(nu_j.dot(S_jj.llt().solve(nu_j)), chi2Limit(2, 0.95) * (1.0 + 1e-9));
        }
        const JointPrior same = drawJointPrior(landmarksFor(12), kind.covariance, again);
        EXPECT_EQ(drawJointPairs(same, {12, 3, kind.outliers}, again).nu, pairs.nu);
    }
}
}  // namespace monoslam::test
