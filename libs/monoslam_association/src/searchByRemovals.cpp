// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

#include "RemovalBound.h"
#include "subsetSearches.h"

namespace monoslam
{
namespace
{
/** Pairs with a looser bound than this are decided first. */
constexpr double kLooseSigma = 0.05;
constexpr double kHeavy = 1e6;

/** Tree of removals (hohct-fast 4.2): pairs are removed one by one by the Schur complement of Lam,
 *  and pairs that RemovalBound shows to be kept in every better set are dropped. */
class RemovalTree
{
   public:
    RemovalTree(const SubsetProblem& problem, long maxNodes, SubsetIncumbent& incumbent,
                SubsetResult& result)
        : m_(problem.pairs()), incumbent_(incumbent), result_(result), nodesLeft_(maxNodes)
    {
    }

    /** \return false if the budget ended */
    bool search(const DowndatingD2& whole)
    {
        Node& root = nodeAt(0);
        root.pairs.resize(static_cast<std::size_t>(m_));
        std::iota(root.pairs.begin(), root.pairs.end(), Eigen::Index{0});
        root.Lam = whole.precision();
        root.gt = whole.weighted();
        root.d2 = whole.d2();
        expand(0);
        return nodesLeft_ >= 0;
    }

   private:
    struct Node
    {
        std::vector<Eigen::Index> pairs;  ///< that may still be removed
        Eigen::MatrixXd Lam;              ///< of them in the leading part
        Eigen::VectorXd gt;
        double d2 = 0.0;
        RemovalBound bound;
    };

    Node& nodeAt(std::size_t depth)
    {
        while (nodes_.size() <= depth)
        {
            nodes_.emplace_back();
            nodes_.back().Lam.resize(2 * m_, 2 * m_);
            nodes_.back().gt.resize(2 * m_);
        }
        return nodes_[depth];
    }

    void expand(std::size_t depth)
    {
        if (--nodesLeft_ < 0) return;
        ++result_.nodes;
        Node& node = nodes_[depth];
        node.bound.measure(node.Lam, node.gt, static_cast<Eigen::Index>(node.pairs.size()));
        tryEachRemoval(node);
        const auto removed = static_cast<Eigen::Index>(removed_.size());
        while (incumbent_.removals() - removed >= 2 && nodesLeft_ >= 0)
        {
            if (!node.bound.keepForced(node.d2, removed, incumbent_)) return;
            const Eigen::Index j = heaviest(node.bound);
            node.bound.drop(j);
            descend(depth, j);
        }
    }

    void tryEachRemoval(const Node& node)
    {
        const auto i = static_cast<Eigen::Index>(removed_.size()) + 1;
        result_.leaves += static_cast<long>(node.pairs.size());
        result_.d2Evaluations += static_cast<long>(node.pairs.size());
        for (std::size_t j = 0; j < node.pairs.size(); ++j)
        {
            const double d2 = node.d2 - node.bound.gain(static_cast<Eigen::Index>(j));
            if (d2 > incumbent_.threshold(i)) continue;
            std::vector<Eigen::Index> removed = removed_;
            removed.push_back(node.pairs[j]);
            incumbent_.replace(std::move(removed), d2);
        }
    }

    /** Of largest gain; before that those whose coupling makes the bound loose. */
    static Eigen::Index heaviest(const RemovalBound& bound)
    {
        Eigen::Index chosen = -1;
        double largest = -1.0;
        for (const Eigen::Index j : bound.open())
        {
            const double sigma = bound.sigma(j);
            const double key = bound.gain(j) + (sigma < kLooseSigma ? kHeavy * (2.0 - sigma) : 0.0);
            if (key <= largest) continue;
            largest = key;
            chosen = j;
        }
        return chosen;
    }

    void descend(std::size_t depth, Eigen::Index j)
    {
        Node& child = nodeAt(depth + 1);
        const Node& node = nodes_[depth];
        const Eigen::Matrix2d Sig_jj = node.Lam.block<2, 2>(2 * j, 2 * j).inverse();
        const Eigen::Vector2d step = Sig_jj * node.gt.segment<2>(2 * j);
        child.d2 = node.d2 - node.bound.gain(j);
        child.pairs.clear();
        Eigen::Index column = 0;
        for (const Eigen::Index l : node.bound.open())
        {
            child.pairs.push_back(node.pairs[static_cast<std::size_t>(l)]);
            const Eigen::Matrix2d Lam_jl = node.Lam.block<2, 2>(2 * j, 2 * l);
            const Eigen::Matrix2d K = Sig_jj * Lam_jl;
            child.gt.segment<2>(2 * column) = node.gt.segment<2>(2 * l) - Lam_jl.transpose() * step;
            Eigen::Index row = 0;
            for (const Eigen::Index k : node.bound.open())
            {
                const Eigen::Matrix2d Lam_kl =
                    node.Lam.block<2, 2>(2 * k, 2 * l) - node.Lam.block<2, 2>(2 * k, 2 * j) * K;
                child.Lam.block<2, 2>(2 * row, 2 * column) = Lam_kl;
                child.Lam.block<2, 2>(2 * column, 2 * row) = Lam_kl.transpose();
                if (row++ == column) break;
            }
            ++column;
        }
        removed_.push_back(node.pairs[static_cast<std::size_t>(j)]);
        expand(depth + 1);
        removed_.pop_back();
    }

    Eigen::Index m_;
    SubsetIncumbent& incumbent_;
    SubsetResult& result_;
    long nodesLeft_;
    std::deque<Node> nodes_;
    std::vector<Eigen::Index> removed_;
};
}  // namespace

bool searchByRemovals(const SubsetProblem& problem, const DowndatingD2& whole, long maxNodes,
                      SubsetIncumbent& incumbent, SubsetResult& result)
{
    return RemovalTree(problem, maxNodes, incumbent, result).search(whole);
}
}  // namespace monoslam
