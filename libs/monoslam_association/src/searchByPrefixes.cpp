// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>

#include "subsetSearches.h"

namespace monoslam
{
namespace
{
/** Keep/remove tree of one number of removals (algorithms 6.5): a prefix whose D2 exceeds the
 *  final limit has no compatible completion, since D2 never falls when a pair is added. */
class PrefixTree
{
   public:
    PrefixTree(const SubsetProblem& problem, const DowndatingD2& whole, NodeAllowance& allowance,
               SubsetIncumbent& incumbent, SubsetResult& result)
        : problem_(problem),
          allowance_(allowance),
          incumbent_(incumbent),
          result_(result),
          kept_(problem.S, problem.pairs()),
          order_(static_cast<std::size_t>(problem.pairs()))
    {
        std::vector<double> w;
        for (Eigen::Index j = 0; j < problem.pairs(); ++j) w.push_back(whole.conditionalNis(j));
        std::iota(order_.begin(), order_.end(), Eigen::Index{0});
        std::sort(order_.begin(), order_.end(),
                  [&w](Eigen::Index a, Eigen::Index b)
                  { return w[static_cast<std::size_t>(a)] > w[static_cast<std::size_t>(b)]; });
        removed_.reserve(order_.size());
    }

    /** \return false if the budget ended */
    bool search(std::size_t removals)
    {
        removals_ = removals;
        grow(0);
        return !ended_;
    }

   private:
    void grow(std::size_t level)
    {
        ended_ = ended_ || !allowance_.spend(1);
        if (ended_) return;
        ++result_.nodes;
        if (level == order_.size()) return leaf();
        const Eigen::Index j = order_[level];
        const std::size_t toRemove = removals_ - removed_.size();
        if (order_.size() - level > toRemove && keep(j))
        {
            grow(level + 1);
            kept_.pop();
        }
        if (toRemove == 0) return;
        removed_.push_back(j);
        grow(level + 1);
        removed_.pop_back();
    }

    bool keep(Eigen::Index j)
    {
        ++result_.d2Evaluations;
        if (!kept_.push({j, problem_.nu.segment<2>(2 * j)})) return false;
        if (kept_.d2() <= incumbent_.threshold(static_cast<Eigen::Index>(removals_))) return true;
        kept_.pop();
        return false;
    }

    void leaf()
    {
        ++result_.leaves;
        if (kept_.d2() <= incumbent_.threshold(static_cast<Eigen::Index>(removals_)))
            incumbent_.replace(removed_, kept_.d2());
    }

    const SubsetProblem& problem_;
    NodeAllowance& allowance_;
    SubsetIncumbent& incumbent_;
    SubsetResult& result_;
    IncrementalD2 kept_;
    std::vector<Eigen::Index> order_;
    std::vector<Eigen::Index> removed_;
    std::size_t removals_ = 0;
    bool ended_ = false;
};
}  // namespace

bool searchByPrefixes(const SubsetProblem& problem, const DowndatingD2& whole,
                      NodeAllowance& allowance, SubsetIncumbent& incumbent, SubsetResult& result)
{
    PrefixTree tree(problem, whole, allowance, incumbent, result);
    for (Eigen::Index i = 1; i < problem.pairs() && i <= incumbent.removals(); ++i)
        if (!tree.search(static_cast<std::size_t>(i))) return false;
    return true;
}
}  // namespace monoslam
