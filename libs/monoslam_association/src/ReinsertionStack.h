// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <vector>

#include "ReinsertionReference.h"
#include "RemovalTree.h"

namespace monoslam
{
/** The pairs kept by a reference and some pairs Y that it removed, put back one at a time.
 *
 *      L L' = Sig_YY,  e = L^-1 nu_Y,  Om = L^-1 W_Y:
 *      D2 = D2* + |e|^2,  gt = gt* - Om'e,  Lam = Lam* + Om'Om          (on the pairs kept)
 *
 * Adding a pair appends two rows to L, e, Om: O(|Y| k), and no matrix of the pairs kept. */
class ReinsertionStack
{
   public:
    explicit ReinsertionStack(const ReinsertionReference& reference);

    void push(Eigen::Index y);
    void pop() { --depth_; }
    [[nodiscard]] Eigen::Index depth() const { return depth_; }
    [[nodiscard]] double d2() const;
    /** Pairs that the reference removes and Y lacks. */
    [[nodiscard]] std::vector<Eigen::Index> removed() const;
    /** Largest gain of a single removal from the pairs kept. */
    [[nodiscard]] double largestGain() const;

    /** Finds the pairs kept that may be removed from a set better than the incumbent, if Y counts
     *  as \p base removals. \return false if there are none */
    bool findReachable(Eigen::Index base, const SubsetIncumbent& incumbent);
    /** The problem of removing those: all but the bound of the node. */
    void copyReachable(RemovalTree::Node& node) const;

   private:
    struct Level
    {
        Eigen::Index y = -1;
        Eigen::ArrayX3d diagonal;  ///< blocks of Lam: (0, 0), (1, 0), (1, 1)
        PairVector gt;
        Eigen::ArrayXd gain;      ///< of removing each pair alone
        Eigen::ArrayXd mostGain;  ///< the same with the reference's Lam, which is less: no lower
        double d2 = 0.0;
    };

    void regress(Eigen::Index y);
    [[nodiscard]] const Level& top() const { return levels_[static_cast<std::size_t>(depth_)]; }
    [[nodiscard]] Level& levelAt(Eigen::Index depth);

    const ReinsertionReference& reference_;
    Eigen::MatrixXd L_;
    Eigen::VectorXd e_;
    Eigen::MatrixXd Omt_;
    std::deque<Level> levels_;
    Eigen::Index depth_ = 0;
    Eigen::ArrayXd values_;
    ReachablePairs reachable_;
};
}  // namespace monoslam
