// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <numeric>

#include "subsetSearches.h"

namespace monoslam
{
namespace
{
/** sum over 1..i of C(m, k) stays below the cap. */
class SubsetCount
{
   public:
    explicit SubsetCount(Eigen::Index m) : m_(static_cast<double>(m)) {}
    double next()
    {
        level_ += 1.0;
        binomial_ *= (m_ - level_ + 1.0) / level_;
        return total_ += binomial_;
    }

   private:
    double m_, level_ = 0.0, binomial_ = 1.0, total_ = 0.0;
};

/** Algorithm 1 with the corrections of algorithms 6.2. */
class PrintedRecursion
{
   public:
    PrintedRecursion(const SubsetProblem& problem, SubsetResult& result)
        : problem_(problem), result_(result)
    {
    }

    struct Hypothesis
    {
        std::vector<bool> kept;
        double d2 = 0.0;
    };

    /** Best of the subsets that begin as \p hyp and lack \p toRemove pairs from \p decided on. */
    Hypothesis best(const std::vector<bool>& hyp, Eigen::Index decided, Eigen::Index toRemove)
    {
        ++result_.nodes;
        Hypothesis bestKnown{hyp, d2(hyp)};
        if (toRemove == 0)
        {
            ++result_.leaves;
            return bestKnown;
        }
        const Eigen::Index last = problem_.pairs() - toRemove;
        for (Eigen::Index r = decided; r <= last; ++r)
        {
            std::vector<bool> child = hyp;
            child[static_cast<std::size_t>(r)] = false;
            Hypothesis below = best(child, r + 1, toRemove - 1);
            if (below.d2 <= bestKnown.d2) bestKnown = std::move(below);
        }
        return bestKnown;
    }

   private:
    double d2(const std::vector<bool>& kept)
    {
        ++result_.d2Evaluations;
        std::vector<Eigen::Index> index;
        for (Eigen::Index i = 0; i < problem_.nu.size(); ++i)
            if (kept[static_cast<std::size_t>(i / 2)]) index.push_back(i);
        const auto k = static_cast<Eigen::Index>(index.size());
        Eigen::MatrixXd S(k, k);
        Eigen::VectorXd nu(k);
        for (Eigen::Index i = 0; i < k; ++i)
        {
            nu(i) = problem_.nu(index[static_cast<std::size_t>(i)]);
            for (Eigen::Index j = 0; j < k; ++j)
                S(i, j) = problem_.S(index[static_cast<std::size_t>(i)],
                                     index[static_cast<std::size_t>(j)]);
        }
        return nu.dot(S.inverse() * nu);
    }

    const SubsetProblem& problem_;
    SubsetResult& result_;
};

/** All subsets R of one size, depth first; D2(all \ R) = D2 - gt_R' Lam_RR^-1 gt_R. */
class DowndatingEnumeration
{
   public:
    DowndatingEnumeration(const SubsetProblem& problem, const DowndatingD2& whole,
                          SubsetIncumbent& incumbent, SubsetResult& result)
        : whole_(whole),
          incumbent_(incumbent),
          result_(result),
          gain_(whole.precision(), problem.pairs()),
          m_(problem.pairs())
    {
    }

    void run(Eigen::Index first, Eigen::Index toRemove)
    {
        if (toRemove == 0) return leaf();
        for (Eigen::Index j = first; j <= m_ - toRemove; ++j)
        {
            if (!gain_.push({j, whole_.weighted().segment<2>(2 * j)})) continue;
            ++result_.nodes;
            removed_.push_back(j);
            run(j + 1, toRemove - 1);
            removed_.pop_back();
            gain_.pop();
        }
    }

   private:
    void leaf()
    {
        ++result_.leaves;
        ++result_.d2Evaluations;
        const double d2 = whole_.d2() - gain_.d2();
        if (d2 <= incumbent_.threshold(gain_.pairs())) incumbent_.replace(removed_, d2);
    }

    const DowndatingD2& whole_;
    SubsetIncumbent& incumbent_;
    SubsetResult& result_;
    IncrementalD2 gain_;
    Eigen::Index m_;
    std::vector<Eigen::Index> removed_;
};
}  // namespace

bool searchAsPrinted(const SubsetProblem& problem, double maxSubsets, SubsetIncumbent& incumbent,
                     SubsetResult& result)
{
    const Eigen::Index m = problem.pairs();
    SubsetCount subsets(m);
    PrintedRecursion recursion(problem, result);
    for (Eigen::Index i = 1; i < m; ++i)
    {
        if (subsets.next() > maxSubsets)
        {
            searchGreedily(problem, DowndatingD2(problem.S, problem.nu), incumbent, result);
            return false;
        }
        const std::vector<bool> all(static_cast<std::size_t>(m), true);
        const auto best = recursion.best(all, 0, i);
        if (best.d2 > problem.limits[static_cast<std::size_t>(i)]) continue;
        std::vector<Eigen::Index> removed;
        for (Eigen::Index j = 0; j < m; ++j)
            if (!best.kept[static_cast<std::size_t>(j)]) removed.push_back(j);
        incumbent.replace(std::move(removed), best.d2);
        return true;
    }
    return true;
}

bool searchByDowndating(const SubsetProblem& problem, const DowndatingD2& whole, double maxSubsets,
                        SubsetIncumbent& incumbent, SubsetResult& result)
{
    SubsetCount subsets(problem.pairs());
    DowndatingEnumeration enumeration(problem, whole, incumbent, result);
    for (Eigen::Index i = 1; i < problem.pairs() && i <= incumbent.removals(); ++i)
    {
        if (subsets.next() > maxSubsets)
        {
            searchGreedily(problem, whole, incumbent, result);
            return false;
        }
        enumeration.run(0, i);
    }
    return true;
}
}  // namespace monoslam
