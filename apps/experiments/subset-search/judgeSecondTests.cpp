// SPDX-License-Identifier: BSD-3-Clause
#include "judgeSecondTests.h"

#include <cstdio>
#include <iterator>

#include "SecondTest.h"

namespace monoslam
{
namespace
{
const SubsetBudget kBudget{0.0, 10000000};

/** Of the pairs accepted. */
struct Verdict
{
    long rightAccepted = 0, wrongAccepted = 0, rightRejected = 0, wrongRejected = 0;
    long problems = 0, exact = 0, withoutWrong = 0;

    void add(const std::vector<Eigen::Index>& removed, const std::vector<char>& wrong)
    {
        std::vector<char> accepted(wrong.size(), 1);
        for (const Eigen::Index j : removed) accepted[static_cast<std::size_t>(j)] = 0;
        long wronglyAccepted = 0, wronglyRejected = 0;
        for (std::size_t j = 0; j < wrong.size(); ++j)
        {
            if (accepted[j] != 0)
                ++(wrong[j] != 0 ? wronglyAccepted : rightAccepted);
            else
                ++(wrong[j] != 0 ? wrongRejected : wronglyRejected);
        }
        wrongAccepted += wronglyAccepted;
        rightRejected += wronglyRejected;
        ++problems;
        withoutWrong += wronglyAccepted == 0 ? 1 : 0;
        exact += wronglyAccepted + wronglyRejected == 0 ? 1 : 0;
    }

    void add(const Verdict& other)
    {
        rightAccepted += other.rightAccepted;
        wrongAccepted += other.wrongAccepted;
        rightRejected += other.rightRejected;
        wrongRejected += other.wrongRejected;
        problems += other.problems;
        exact += other.exact;
        withoutWrong += other.withoutWrong;
    }

    void print() const
    {
        const auto share = [](long part, long rest)
        { return 100.0 * static_cast<double>(part) / static_cast<double>(part + rest); };
        std::printf(" %.2f | %.2f | %.1f | %.1f | %.1f |", share(rightAccepted, wrongAccepted),
                    share(rightAccepted, rightRejected), share(wrongRejected, wrongAccepted),
                    share(withoutWrong, problems - withoutWrong), share(exact, problems - exact));
    }
};

/** Those that are also shown kind by kind come first. */
constexpr std::size_t kShownByKind = 4;
std::vector<SecondTest> listTests()
{
    return {{},
            {SecondRule::Conditional, 0.999, true},
            {SecondRule::Joint, 0.5, false},
            {SecondRule::Likelihood, 0.9, true},
            {SecondRule::Conditional, 0.99, false},
            {SecondRule::Conditional, 0.99, true},
            {SecondRule::Conditional, 0.999, false},
            {SecondRule::Conditional, 0.9999, false},
            {SecondRule::Conditional, 0.9999, true},
            {SecondRule::Joint, 0.2, false},
            {SecondRule::Likelihood, 0.5, false},
            {SecondRule::Likelihood, 0.5, true},
            {SecondRule::Likelihood, 0.9, false},
            {SecondRule::Likelihood, 0.97, false},
            {SecondRule::Likelihood, 0.97, true}};
}

constexpr const char* kColumns =
    " precision | recall | wrong found | no wrong left | exact set |\n";

/** verdicts[test][kind], kind = covariance, outliers. */
using Verdicts = std::vector<std::vector<Verdict>>;
constexpr const char* kKindNames[] = {"IND UN", "IND CL", "EKF UN", "EKF CL"};

std::size_t kindOf(const Cell& cell)
{
    return (cell.covariance == CovarianceKind::Filter ? 2U : 0U) +
           (cell.outliers == OutlierKind::Cluster ? 1U : 0U);
}

void printByKind(const std::vector<SecondTest>& tests, const Verdicts& verdicts)
{
    std::printf("\n| problems | second test |%s|---|---|--:|--:|--:|--:|--:|\n", kColumns);
    for (std::size_t kind = 0; kind < std::size(kKindNames); ++kind)
        for (std::size_t t = 0; t < kShownByKind; ++t)
        {
            std::printf("| %s | %s |", kKindNames[kind], tests[t].name().c_str());
            verdicts[t][kind].print();
            std::printf("\n");
        }
}
}  // namespace

void judgeSecondTests(unsigned seeds)
{
    const std::vector<SecondTest> tests = listTests();
    Verdicts verdicts(tests.size(), std::vector<Verdict>(std::size(kKindNames)));
    std::vector<Verdict> clean(tests.size());
    ProblemSource source(seeds);
    for (const Cell& cell : listCells())
        for (const DrawnProblem& drawn : source.draw(cell))
        {
            const auto found =
                largestCompatibleSubset(drawn.problem, SubsetSearch::Automatic, kBudget);
            for (std::size_t t = 0; t < tests.size(); ++t)
            {
                const auto removed = applySecondTest(drawn.problem, found.removed, tests[t]);
                (cell.r == 0 ? clean[t] : verdicts[t][kindOf(cell)]).add(removed, drawn.wrong);
            }
        }
    std::printf("| second test |%s|---|--:|--:|--:|--:|--:|--:|\n",
                " precision | recall | wrong found | no wrong left | exact set | "
                "exact set, r = 0 |\n");
    for (std::size_t t = 0; t < tests.size(); ++t)
    {
        Verdict all;
        for (const Verdict& verdict : verdicts[t]) all.add(verdict);
        std::printf("| %s |", tests[t].name().c_str());
        all.print();
        std::printf(" %.1f |\n", 100.0 * static_cast<double>(clean[t].exact) /
                                     static_cast<double>(clean[t].problems));
    }
    printByKind(tests, verdicts);
}
}  // namespace monoslam
