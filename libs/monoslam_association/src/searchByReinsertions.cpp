// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ReinsertionStack.h"

namespace monoslam
{
namespace
{
/** Nodes that the proof against all supersets may take for each undecided pair. */
constexpr long kProofNodes = 16;
/** Work of a node, in nodes of the prefix tree. */
constexpr long kNodeWork = 32;

/** Sets are the reference, without some pairs X that it keeps, with some Y that it removed. The
 *  tree decides about Y (hohct-fast 4.3); for each Y the removal tree searches the X. */
class ReinsertionTree
{
   public:
    ReinsertionTree(NodeAllowance& allowance, SubsetIncumbent& incumbent, SubsetResult& result)
        : allowance_(allowance),
          incumbent_(incumbent),
          result_(result),
          removals_(allowance, incumbent, result)
    {
    }

    /** Starts again from every better set. \return false if the allowance ended */
    bool search(const DowndatingD2& whole)
    {
        do
        {
            const ReinsertionReference reference(whole, incumbent_.removed());
            r_ = static_cast<Eigen::Index>(reference.removed.size());
            d2_ = incumbent_.d2();
            ReinsertionStack stack(reference);
            decide(stack, 0);
        } while (!ended_ && improved());
        return !ended_;
    }

   private:
    [[nodiscard]] bool improved() const
    {
        return incumbent_.removals() != r_ || incumbent_.d2() != d2_;
    }

    /** All sets with the pairs on the stack and some of those from \p next on. */
    void decide(ReinsertionStack& stack, Eigen::Index next)
    {
        ended_ = ended_ || !allowance_.spend(kNodeWork);
        if (ended_) return;
        ++result_.nodes;
        if (stack.depth() > 0 && settle(stack, r_ - next)) return;
        for (Eigen::Index y = next; y < r_ && !ended_ && !improved(); ++y)
        {
            stack.push(y);
            decide(stack, y + 1);
            stack.pop();
        }
    }

    /** The sets with just these pairs. \return true if sets with more cannot be better either */
    bool settle(ReinsertionStack& stack, Eigen::Index undecided)
    {
        const Eigen::Index removals = r_ - stack.depth();
        ++result_.leaves;
        ++result_.d2Evaluations;
        if (stack.d2() <= incumbent_.threshold(removals))
            incumbent_.replace(stack.removed(), stack.d2());
        if (excludes(stack, removals - undecided, undecided)) return true;
        if (!stack.findReachable(removals, incumbent_)) return undecided == 0;
        stack.copyReachable(removals_.root());
        ended_ = !removals_.search(stack.removed());
        return undecided == 0;
    }

    /** D2 of a set with more pairs is no less, and it has at least \p base removals. */
    bool excludes(ReinsertionStack& stack, Eigen::Index base, Eigen::Index undecided)
    {
        if (stack.d2() - ReachablePairs::kMargin <= incumbent_.threshold(base)) return false;
        if (!stack.findReachable(base, incumbent_)) return true;
        if (undecided == 0 || stack.d2() - stack.largestGain() <= incumbent_.threshold(base + 1))
            return false;
        stack.copyReachable(removals_.root());
        return removals_.excludes(base, kProofNodes * undecided);
    }

    NodeAllowance& allowance_;
    SubsetIncumbent& incumbent_;
    SubsetResult& result_;
    RemovalTree removals_;
    Eigen::Index r_ = 0;
    double d2_ = 0.0;
    bool ended_ = false;
};
}  // namespace

bool searchByReinsertions(const DowndatingD2& whole, NodeAllowance& allowance,
                          SubsetIncumbent& incumbent, SubsetResult& result)
{
    return ReinsertionTree(allowance, incumbent, result).search(whole);
}
}  // namespace monoslam
