// SPDX-License-Identifier: BSD-3-Clause
#include "SecondTest.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "monoslam_association/jointCompatibility.h"

namespace monoslam
{
namespace
{
constexpr double kGate = 0.95;
constexpr Eigen::Index kPoseFixingPairs = 3;

/** A pair given others: S and NIS of its innovation. */
struct Conditional
{
    Eigen::Matrix2d S;
    double nis = 0.0;
};

/** How much of the pair's NIS the test tolerates. */
class Tolerance
{
   public:
    Tolerance(const SubsetProblem& problem, const SecondTest& test) : problem_(problem), test_(test)
    {
    }

    [[nodiscard]] bool rejects(Eigen::Index j, const Conditional& given, double d2,
                               Eigen::Index kept) const
    {
        if (test_.rule == SecondRule::Conditional) return given.nis > chi2Limit(2, test_.p);
        if (test_.rule == SecondRule::Joint)
            return d2 > chi2Limit(2 * kept, test_.p) && given.nis > chi2Limit(2, kGate);
        const Eigen::Matrix2d S_jj = problem_.S.block<2, 2>(2 * j, 2 * j);
        const double ofGates = std::sqrt(S_jj.determinant() / given.S.determinant());
        return given.nis >
               2.0 * std::log(0.5 * chi2Limit(2, kGate) * ofGates * test_.p / (1.0 - test_.p));
    }

   private:
    const SubsetProblem& problem_;
    const SecondTest& test_;
};

std::vector<Eigen::Index> keptPairs(Eigen::Index m, const std::vector<Eigen::Index>& removed)
{
    std::vector<Eigen::Index> kept;
    for (Eigen::Index j = 0; j < m; ++j)
        if (std::find(removed.begin(), removed.end(), j) == removed.end()) kept.push_back(j);
    return kept;
}

void removeWorst(const SubsetProblem& problem, const Tolerance& tolerance,
                 std::vector<Eigen::Index>& removed)
{
    DowndatingD2 kept(problem.S, problem.nu);
    for (const Eigen::Index j : removed) kept.remove(j);
    for (Eigen::Index j = kept.worst(); j >= 0; j = kept.worst())
    {
        const Eigen::Matrix2d Lam_jj = kept.precision().block<2, 2>(2 * j, 2 * j);
        const Conditional given{Lam_jj.inverse(), kept.conditionalNis(j)};
        const auto count = problem.pairs() - static_cast<Eigen::Index>(removed.size());
        if (!tolerance.rejects(j, given, kept.d2(), count)) return;
        kept.remove(j);
        removed.push_back(j);
    }
}

void putBack(const SubsetProblem& problem, const Tolerance& tolerance,
             std::vector<Eigen::Index>& removed)
{
    const auto kept = keptPairs(problem.pairs(), removed);
    const auto k = static_cast<Eigen::Index>(kept.size());
    if (k < kPoseFixingPairs) return;
    Eigen::MatrixXd S(2 * k, 2 * k), S_Kr(2 * k, 2 * static_cast<Eigen::Index>(removed.size()));
    Eigen::VectorXd nu(2 * k);
    for (Eigen::Index l = 0; l < k; ++l)
    {
        const Eigen::Index row = 2 * kept[static_cast<std::size_t>(l)];
        nu.segment<2>(2 * l) = problem.nu.segment<2>(row);
        for (Eigen::Index i = 0; i < k; ++i)
            S.block<2, 2>(2 * l, 2 * i) =
                problem.S.block<2, 2>(row, 2 * kept[static_cast<std::size_t>(i)]);
        for (std::size_t i = 0; i < removed.size(); ++i)
            S_Kr.block<2, 2>(2 * l, 2 * static_cast<Eigen::Index>(i)) =
                problem.S.block<2, 2>(row, 2 * removed[i]);
    }
    const Eigen::LLT<Eigen::MatrixXd> llt(S);
    const Eigen::VectorXd solved = llt.solve(nu);
    std::vector<Eigen::Index> still;
    for (std::size_t i = 0; i < removed.size(); ++i)
    {
        const Eigen::Index j = removed[i];
        const Eigen::MatrixX2d S_Kj = S_Kr.middleCols<2>(2 * static_cast<Eigen::Index>(i));
        const Eigen::Vector2d nu_j = problem.nu.segment<2>(2 * j) - S_Kj.transpose() * solved;
        Conditional given;
        given.S = problem.S.block<2, 2>(2 * j, 2 * j) - S_Kj.transpose() * llt.solve(S_Kj);
        given.nis = nu_j.dot(given.S.inverse() * nu_j);
        if (tolerance.rejects(j, given, nu.dot(solved) + given.nis, k + 1)) still.push_back(j);
    }
    removed = std::move(still);
}
}  // namespace

std::string SecondTest::name() const
{
    char text[96];
    const char* const back = putBack ? ", then put back" : "";
    switch (rule)
    {
        case SecondRule::None:
            return "none";
        case SecondRule::Conditional:
            std::snprintf(text, sizeof text, "conditional NIS at %g%s", p, back);
            break;
        case SecondRule::Joint:
            std::snprintf(text, sizeof text, "joint at %g, gain at %g%s", p, kGate, back);
            break;
        case SecondRule::Likelihood:
            std::snprintf(text, sizeof text, "likelihood ratio, right with %g%s", p, back);
            break;
    }
    return text;
}

std::vector<Eigen::Index> applySecondTest(const SubsetProblem& problem,
                                          std::vector<Eigen::Index> removed, const SecondTest& test)
{
    if (test.rule == SecondRule::None) return removed;
    const Tolerance tolerance(problem, test);
    removeWorst(problem, tolerance, removed);
    if (test.putBack) putBack(problem, tolerance, removed);
    return removed;
}
}  // namespace monoslam
