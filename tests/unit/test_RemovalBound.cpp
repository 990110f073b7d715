// SPDX-License-Identifier: BSD-3-Clause
// The bound and the re-insertion formulas against plain linear algebra.
#include "RemovalBound.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <numeric>

#include "ReinsertionStack.h"
#include "drawnProblems.h"

namespace monoslam::test
{
namespace
{
const Chi2Table kTable(0.95, 100);

std::vector<Eigen::Index> firstPairs(Eigen::Index n)
{
    std::vector<Eigen::Index> pairs(static_cast<std::size_t>(n));
    std::iota(pairs.begin(), pairs.end(), Eigen::Index{0});
    return pairs;
}

/** Calls visit(X as a mask) for each of the subsets of x of m pairs. */
template <class Visit>
void forEachSubset(Eigen::Index m, int x, const Visit& visit)
{
    for (unsigned mask = 0; mask < 1U << m; ++mask)
        if (__builtin_popcount(mask) == x) visit(mask);
}
}  // namespace

TEST(RemovalBound, IsNeverBelowTheGainOfAnySubset)
{
    long checked = 0, finite = 0;
    for (unsigned seed = 0; seed < 200; ++seed)
    {
        const Eigen::Index m = 11;
        const SubsetProblem problem = drawProblem(m, 2, kTable, seed);
        DowndatingD2 whole(problem.S, problem.nu);
        PairMatrix Lam;
        Lam.gather(whole.precision(), firstPairs(m));
        RemovalBound bound;
        bound.measure(Lam, gatherRows(whole.weighted(), firstPairs(m)).reshaped(m, 2));
        bound.couple(4);
        for (Eigen::Index j = 0; j < m; ++j)
            EXPECT_NEAR(bound.gain(j), whole.conditionalNis(j), 1e-7 * (1.0 + bound.gain(j)));
        for (int x = 2; x <= 4; ++x)
            forEachSubset(m, x,
                          [&](unsigned mask)
                          {
                              double most = 0.0;
                              for (Eigen::Index j = 0; j < m; ++j)
                                  if (mask >> j & 1U)
                                      most += bound.sigma(j, x) > 0.0
                                                  ? bound.gain(j) / bound.sigma(j, x)
                                                  : std::numeric_limits<double>::infinity();
                              const double gain =
                                  whole.d2() - denseD2(problem, ~mask & ((1U << m) - 1));
                              EXPECT_LE(gain, most + 1e-7 * (1.0 + whole.d2()));
                              ++checked;
                              finite += most < std::numeric_limits<double>::infinity() ? 1 : 0;
                          });
    }
    EXPECT_EQ(checked, 200 * (55 + 165 + 330));
    EXPECT_GT(finite, 1000);
}

/** sigma_j(x) from the definition: norms of the blocks that Cholesky factors of the diagonal whiten. */
TEST(RemovalBound, SigmaIsOneMinusTheLargestWhitenedBlocks)
{
    for (const Eigen::Index m : {3, 7, 8, 9, 19, 24})
    {
        const SubsetProblem problem = drawProblem(m, 1, kTable, static_cast<unsigned>(m));
        const DowndatingD2 whole(problem.S, problem.nu);
        PairMatrix Lam;
        Lam.gather(whole.precision(), firstPairs(m));
        RemovalBound bound;
        bound.measure(Lam, gatherRows(whole.weighted(), firstPairs(m)).reshaped(m, 2));
        const Eigen::Index most = std::min<Eigen::Index>(m - 1, 6);
        bound.couple(most);
        const auto factor = [&](Eigen::Index j) -> Eigen::Matrix2d
        { return whole.precision().block<2, 2>(2 * j, 2 * j).llt().matrixL(); };
        for (Eigen::Index j = 0; j < m; ++j)
        {
            std::vector<double> norms;
            for (Eigen::Index l = 0; l < m; ++l)
                if (l != j)
                    norms.push_back(
                        (factor(j).inverse() * whole.precision().block<2, 2>(2 * j, 2 * l) *
                         factor(l).inverse().transpose())
                            .jacobiSvd()
                            .singularValues()(0));
            std::sort(norms.rbegin(), norms.rend());
            double sum = 0.0;
            for (Eigen::Index x = 2; x <= most; ++x)
            {
                sum += norms[static_cast<std::size_t>(x - 2)];
                EXPECT_NEAR(bound.sigma(j, x), 1.0 - sum, 1e-9) << m << ' ' << j << ' ' << x;
            }
        }
    }
}

TEST(RemovalBound, KeepsNoPairThatABetterSetLacks)
{
    for (unsigned seed = 0; seed < 300; ++seed)
    {
        const Eigen::Index m = 8;
        const SubsetProblem problem = drawProblem(m, 1 + seed / 4 % 3, kTable, seed);
        const SubsetResult best = bruteForce(problem);
        if (best.removed.size() < 2) continue;
        DowndatingD2 whole(problem.S, problem.nu);
        SubsetIncumbent incumbent(problem);
        SubsetResult counts;
        searchGreedily(problem, whole, incumbent, counts);
        if (incumbent.removed().size() == best.removed.size() && incumbent.d2() < best.d2 + 1e-9)
            incumbent.replace(incumbent.removed(), best.d2 + 1.0);
        PairMatrix Lam;
        Lam.gather(whole.precision(), firstPairs(m));
        RemovalBound bound;
        bound.measure(Lam, gatherRows(whole.weighted(), firstPairs(m)).reshaped(m, 2));
        ASSERT_TRUE(bound.keepForced(whole.d2(), 0, incumbent)) << "seed " << seed;
        for (const Eigen::Index j : best.removed)
            EXPECT_NE(std::find(bound.open().begin(), bound.open().end(), j), bound.open().end());
    }
}

TEST(ReinsertionStack, EqualsTheDenseFormForEverySetPutBack)
{
    for (unsigned seed = 0; seed < 60; ++seed)
    {
        const Eigen::Index m = 10;
        const SubsetProblem problem = drawProblem(m, 3, kTable, seed);
        const DowndatingD2 whole(problem.S, problem.nu);
        const ReinsertionReference reference(whole, {1, 4, 5, 9});
        ReinsertionStack stack(reference);
        const double scale = 1.0 + whole.d2();
        EXPECT_NEAR(stack.d2(), denseD2(problem, 0x1CDU), 1e-8 * scale);
        for (const Eigen::Index y : {0, 2, 3})
        {
            stack.push(y);
            unsigned kept = (1U << m) - 1;
            for (const Eigen::Index j : stack.removed()) kept &= ~(1U << j);
            EXPECT_NEAR(stack.d2(), denseD2(problem, kept), 1e-8 * scale);
            double largest = 0.0;
            for (const Eigen::Index j : reference.kept)
                largest = std::max(largest, stack.d2() - denseD2(problem, kept & ~(1U << j)));
            EXPECT_NEAR(stack.largestGain(), largest, 1e-8 * scale);
        }
        stack.pop();
        EXPECT_EQ(stack.removed().size(), 2U);
    }
}
}  // namespace monoslam::test
