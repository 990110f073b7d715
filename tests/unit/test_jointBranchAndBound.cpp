// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <optional>

#include "associatorRuns.h"
#include "subsetProblems.h"

namespace monoslam::test
{
namespace
{
const Chi2Table kTable(0.95, 100);

/** m landmarks of two candidates each, that share a pose error; right candidates are first or
 *  second. */
struct Ambiguous
{
    Eigen::MatrixXd HPHt;
    JcbbProblem problem;

    Ambiguous(Eigen::Index m, std::mt19937& rng)
    {
        const SubsetProblem right = randomProblem(m, 1, kTable, rng);
        const Eigen::Matrix2d R = Eigen::Matrix2d::Identity();
        HPHt = right.S - Eigen::MatrixXd::Identity(2 * m, 2 * m);
        problem.HPHt = &HPHt;
        for (Eigen::Index j = 0; j < m; ++j)
        {
            const Eigen::Vector2d nu = right.nu.segment<2>(2 * j);
            const Eigen::Vector2d other = nu + 2.0 * gaussian(2, 1, rng);
            problem.pairs.push_back({{j, nu, R}, {j, other, R}});
            problem.pixels.push_back({nu, other});
        }
    }
    Ambiguous(const Ambiguous&) = delete;
    Ambiguous& operator=(const Ambiguous&) = delete;
    ~Ambiguous() = default;
};

/** By dense inversion; nothing if the set is not compatible. */
std::optional<double> compatibleD2(const Ambiguous& a, const std::vector<int>& chosen)
{
    SubsetProblem dense;
    const auto m = static_cast<Eigen::Index>(chosen.size());
    dense.S = a.HPHt + Eigen::MatrixXd::Identity(a.HPHt.rows(), a.HPHt.cols());
    dense.nu = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(a.problem.pairs.size()));
    unsigned kept = 0;
    for (Eigen::Index j = 0; j < m; ++j)
    {
        const int c = chosen[static_cast<std::size_t>(j)];
        if (c < 0) continue;
        kept |= 1U << j;
        dense.nu.segment<2>(2 * j) =
            a.problem.pairs[static_cast<std::size_t>(j)][static_cast<std::size_t>(c)].nu;
    }
    const double d2 = denseD2(dense, kept);
    if (d2 > kTable(2 * __builtin_popcount(kept))) return std::nullopt;
    return d2;
}

struct Best
{
    long pairs = 0;
    double d2 = 0.0;
    std::vector<int> chosen;
};

/** All assignments whose every prefix is compatible, by dense inversion. */
void enumerate(const Ambiguous& a, std::vector<int>& chosen, Best& best)
{
    const auto d2 = compatibleD2(a, chosen);
    if (!d2) return;
    if (chosen.size() == a.problem.pairs.size())
    {
        const long pairs =
            static_cast<long>(chosen.size()) - std::count(chosen.begin(), chosen.end(), -1);
        if (pairs > best.pairs || (pairs == best.pairs && *d2 < best.d2))
            best = {pairs, *d2, chosen};
        return;
    }
    for (const int c : {0, 1, -1})
    {
        chosen.push_back(c);
        enumerate(a, chosen, best);
        chosen.pop_back();
    }
}
}  // namespace

TEST(JointBranchAndBound, EqualsBruteForceOnAThousandProblemsOfSeveralCandidates)
{
    std::mt19937 rng(7);
    long searched = 0;
    for (int run = 0; searched < 1000; ++run)
    {
        const Ambiguous a(3 + run % 3, rng);
        const JcbbResult bounded = jointBranchAndBound(a.problem, kTable, {true, 1000000});
        const JcbbResult whole = jointBranchAndBound(a.problem, kTable, {false, 1000000});
        ASSERT_EQ(bounded.searched, whole.searched);
        if (!bounded.searched)  // the nearest of each passed at once
        {
            ASSERT_EQ(pairsOf(bounded), a.problem.pairs.size());
            continue;
        }
        ++searched;
        Best best;
        best.chosen.assign(a.problem.pairs.size(), -1);
        std::vector<int> chosen;
        enumerate(a, chosen, best);
        ASSERT_EQ(bounded.chosen, best.chosen) << "run " << run;
        ASSERT_EQ(whole.chosen, best.chosen) << "run " << run;
        ASSERT_NEAR(bounded.d2, best.d2, 1e-9 * (1.0 + best.d2));
        ASSERT_NEAR(whole.d2, best.d2, 1e-9 * (1.0 + best.d2));
        ASSERT_LE(bounded.nodes, whole.nodes);
    }
}

TEST(JointBranchAndBound, ReturnsTheBestSoFarAtTheCapAndSaysSo)
{
    std::mt19937 rng(8);
    int capped = 0;
    for (int run = 0; run < 50; ++run)
    {
        const Ambiguous a(8, rng);
        const JcbbResult all = jointBranchAndBound(a.problem, kTable, {false, 10000000});
        const JcbbResult some = jointBranchAndBound(a.problem, kTable, {false, 12});
        if (some.finished) continue;
        ++capped;
        EXPECT_LE(some.nodes, 12);
        EXPECT_GT(all.nodes, 12);
        EXPECT_LE(pairsOf(some), pairsOf(all));
        ASSERT_TRUE(compatibleD2(a, some.chosen));  // what is returned is compatible
        EXPECT_NEAR(*compatibleD2(a, some.chosen), some.d2, 1e-9 * (1.0 + some.d2));
    }
    EXPECT_GT(capped, 10);
}

TEST(Jcbb, CountsACappedFrameAsNotProved)
{
    LinearWorld world = LinearWorld::withLandmarks(30, 10);
    for (const LandmarkId id : {2, 9, 17, 28}) world.displace(id, {-9.0, 10.0});
    const std::string ini = "first_stage_landmarks = 0\n[association.jcbb]\n";
    EXPECT_TRUE(run("jcbb", world, ini).counters.provedOptimal);
    const Correction capped = run("jcbb", world, ini + "bound = false\nnode_cap = 50");
    EXPECT_FALSE(capped.counters.provedOptimal);
    EXPECT_LE(capped.counters.nodes, 50);
    for (const LandmarkId id : {2, 9, 17, 28}) EXPECT_EQ(recordOf(capped, id).fate, Fate::Rejected);
}
}  // namespace monoslam::test
