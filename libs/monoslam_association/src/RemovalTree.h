// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <vector>

#include "NodeAllowance.h"
#include "PairMatrix.h"
#include "RemovalBound.h"
#include "subsetSearches.h"

namespace monoslam
{
/** Tree of removals (hohct-fast 4.2): pairs are removed one by one by the Schur complement of Lam,
 *  and pairs that RemovalBound shows to be kept in every better set are dropped. The last removal
 *  but one is followed by the test of every last one, without a node. */
class RemovalTree
{
   public:
    /** Work of a node, in nodes of the prefix tree. */
    static constexpr long kNodeWork = 256;

    struct Node
    {
        std::vector<Eigen::Index> pairs;  ///< that may still be removed
        PairMatrix Lam;                   ///< of them
        PairVector gt;
        double d2 = 0.0;
        RemovalBound bound;
        Eigen::MatrixX4d Lam_j;  ///< scratch: blocks with the pair removed on the way here
    };

    RemovalTree(NodeAllowance& allowance, SubsetIncumbent& incumbent, SubsetResult& result)
        : allowance_(allowance), incumbent_(incumbent), result_(result)
    {
    }

    /** To be filled before search() or excludes(), all but its bound. */
    [[nodiscard]] Node& root() { return nodeAt(0); }

    /** All better sets that lack \p without and some of the root's pairs.
     *  \return false if the allowance ended */
    bool search(const std::vector<Eigen::Index>& without);

    /** Whether no set of the root is below the threshold of \p base more removals than it has;
     *  gives up, false, after \p maxNodes. */
    bool excludes(Eigen::Index base, long maxNodes);

   private:
    [[nodiscard]] Node& nodeAt(std::size_t depth);
    [[nodiscard]] Eigen::Index removals(std::size_t depth) const
    {
        return base_ + static_cast<Eigen::Index>(depth);
    }
    bool mayExpand();
    void expand(std::size_t depth);
    void descend(std::size_t depth, Eigen::Index j);
    void tryEachRemoval(std::size_t depth);
    void tryEachLast(std::size_t depth, Eigen::Index j);
    void accept(Eigen::Index pair, double d2, std::size_t depth);

    NodeAllowance& allowance_;
    SubsetIncumbent& incumbent_;
    SubsetResult& result_;
    std::deque<Node> nodes_;
    std::vector<Eigen::Index> removed_;
    Eigen::Index base_ = 0;
    long nodesLeft_ = 0;
    bool onlyExcludes_ = false;
    bool ended_ = false;  ///< no more nodes, or a set that was to be excluded
};
}  // namespace monoslam
