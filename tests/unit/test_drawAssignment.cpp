// SPDX-License-Identifier: BSD-3-Clause
#include "drawAssignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "assignmentProblems.h"

namespace monoslam::test
{
namespace
{
const DetectionModel kModel{0.8, 0.01};

/** N(nu; 0, S) of a set of pairs. */
double density(const AssignmentProblem& problem, AssignmentResult result)
{
    measureDensely(problem, result);
    const auto numbers = static_cast<double>(problem.dimension * result.pairs);
    return std::exp(-0.5 * (result.d2 + result.logDet + numbers * std::log(2.0 * std::acos(-1.0))));
}

/** Odds of detection and the density of clutter to the power of the items left out. */
double likelihood(const AssignmentProblem& problem, const AssignmentResult& result)
{
    const double odds = kModel.p_detection / (1.0 - kModel.p_detection);
    double product = density(problem, result);
    for (const int c : result.chosen) product *= c < 0 ? kModel.clutter_density : odds;
    return product;
}

/** One item, then a second that wants the same prediction. */
AssignmentProblem twoItems()
{
    AssignmentProblem problem;
    problem.dimension = 1;
    problem.HPHt = Eigen::Matrix2d{{9.0, 8.0}, {8.0, 9.0}};
    problem.limits = {0.0, 1e9, 1e9};
    const auto nu = [](double x) { return Eigen::VectorXd::Constant(1, x); };
    problem.items = {{{0, 0, nu(1.0), {}}, {1, 1, nu(-2.0), {}}}, {{1, 1, nu(1.5), {}}}};
    return problem;
}
}  // namespace

TEST(DrawAssignment, DrawsForOnePredictionInProportionAndWeighsByTheSum)
{
    AssignmentProblem problem = twoItems();
    problem.items[0].erase(problem.items[0].begin());  // both want the second prediction
    std::vector<double> l;
    for (const std::vector<int>& chosen : {std::vector<int>{-1, -1}, {0, -1}, {-1, 0}})
    {
        AssignmentResult result;
        result.chosen = chosen;
        l.push_back(likelihood(problem, result));
    }
    const double sum = std::accumulate(l.begin(), l.end(), 0.0);
    std::mt19937 rng(1);
    std::vector<double> count(3, 0.0);
    constexpr int kDraws = 20000;
    for (int k = 0; k < kDraws; ++k)
    {
        const DrawnAssignment drawn = drawAssignment(problem, kModel, rng);
        ASSERT_NEAR(drawn.logWeight, std::log(sum), 1e-12);
        const std::vector<int>& chosen = drawn.assignment.chosen;
        count[chosen[0] == 0 ? 1 : chosen[1] == 0 ? 2 : 0] += 1.0;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
        const double p = l[i] / sum, sigma = std::sqrt(p * (1.0 - p) / kDraws);
        EXPECT_NEAR(count[i] / kDraws, p, 4.0 * sigma);
    }
}

TEST(DrawAssignment, WeighsSoThatTheMeanIsTheLikelihoodOfAllAssignments)
{
    // Importance sampling: the mean of the weights is the sum over assignments, whatever the order.
    const AssignmentProblem problem = twoItems();
    double total = 0.0;
    for (const int a : {-1, 0, 1})
        for (const int b : {-1, 0})
        {
            if (a == 1 && b == 0) continue;  // both want the second prediction
            AssignmentResult result;
            result.chosen = {a, b};
            total += likelihood(problem, result);
        }
    std::mt19937 rng(2);
    constexpr int kDraws = 40000;
    double sum = 0.0, squares = 0.0;
    for (int k = 0; k < kDraws; ++k)
    {
        const double w = std::exp(drawAssignment(problem, kModel, rng).logWeight);
        sum += w;
        squares += w * w;
    }
    const double mean = sum / kDraws;
    const double sigma = std::sqrt((squares / kDraws - mean * mean) / kDraws);
    EXPECT_NEAR(mean, total, 4.0 * sigma);
    EXPECT_LT(sigma, 0.02 * total);
}

TEST(DrawAssignment, NeverGivesAPredictionTwiceAndRepeatsItsDraws)
{
    std::mt19937 problems(3);
    for (int run = 0; run < 200; ++run)
    {
        const AssignmentProblem problem =
            randomAssignment({2 + run % 2, 6, 5, 1, 0.99, false}, problems);
        std::mt19937 a(static_cast<unsigned>(run)), b = a;
        const DrawnAssignment first = drawAssignment(problem, kModel, a);
        EXPECT_EQ(first.assignment.chosen, drawAssignment(problem, kModel, b).assignment.chosen);
        std::set<Eigen::Index> used;
        for (std::size_t i = 0; i < problem.items.size(); ++i)
        {
            const int c = first.assignment.chosen[i];
            if (c < 0) continue;
            EXPECT_TRUE(used.insert(problem.items[i][static_cast<std::size_t>(c)].use).second);
        }
        AssignmentResult dense = first.assignment;
        measureDensely(problem, dense);
        EXPECT_NEAR(first.assignment.d2, dense.d2, 1e-9 * (1.0 + dense.d2));
    }
}
}  // namespace monoslam::test
