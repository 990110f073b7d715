// SPDX-License-Identifier: BSD-3-Clause
#include "RemovalTree.h"

#include <Eigen/LU>
#include <limits>

namespace monoslam
{
namespace
{
/** Pairs with a looser bound than this are decided first, the loosest before all. */
constexpr double kLooseSigma = 0.05;
constexpr double kHeavy = 1e6;

/** Of largest gain; before that those whose coupling makes the bound loose. */
Eigen::Index heaviest(const RemovalBound& bound, Eigen::Index most)
{
    Eigen::Index chosen = -1;
    double largest = -1.0;
    for (const Eigen::Index j : bound.open())
    {
        const double sigma = bound.sigma(j, most);
        const double key = bound.gain(j) + (sigma < kLooseSigma ? kHeavy * (2.0 - sigma) : 0.0);
        if (key <= largest) continue;
        largest = key;
        chosen = j;
    }
    return chosen;
}

/** Effect of the removal of pair j on another one, l. */
struct Schur
{
    Eigen::Matrix2d Sig_jj;
    Eigen::Vector2d step;

    Schur(const RemovalTree::Node& node, Eigen::Index j)
        : Sig_jj(node.Lam.block(j, j).inverse()), step(Sig_jj * node.gt.row(j).matrix().transpose())
    {
    }
};
}  // namespace

RemovalTree::Node& RemovalTree::nodeAt(std::size_t depth)
{
    while (nodes_.size() <= depth) nodes_.emplace_back();
    return nodes_[depth];
}

bool RemovalTree::search(const std::vector<Eigen::Index>& without)
{
    removed_ = without;
    base_ = static_cast<Eigen::Index>(without.size());
    nodesLeft_ = std::numeric_limits<long>::max();
    onlyExcludes_ = false;
    ended_ = false;
    expand(0);
    return !ended_;
}

bool RemovalTree::excludes(Eigen::Index base, long maxNodes)
{
    removed_.clear();
    base_ = base;
    nodesLeft_ = maxNodes;
    onlyExcludes_ = true;
    ended_ = false;
    expand(0);
    return !ended_;
}

bool RemovalTree::mayExpand()
{
    ended_ = ended_ || --nodesLeft_ < 0 || !allowance_.spend(kNodeWork);
    if (!ended_) ++result_.nodes;
    return !ended_;
}

void RemovalTree::accept(Eigen::Index pair, double d2, std::size_t depth)
{
    if (d2 > incumbent_.threshold(removals(depth) + 1)) return;
    if (onlyExcludes_)
    {
        ended_ = true;
        return;
    }
    std::vector<Eigen::Index> removed = removed_;
    removed.push_back(pair);
    incumbent_.replace(std::move(removed), d2);
}

void RemovalTree::tryEachRemoval(std::size_t depth)
{
    const Node& node = nodes_[depth];
    result_.leaves += static_cast<long>(node.pairs.size());
    result_.d2Evaluations += static_cast<long>(node.pairs.size());
    for (std::size_t j = 0; j < node.pairs.size() && !ended_; ++j)
        accept(node.pairs[j], node.d2 - node.bound.gain(static_cast<Eigen::Index>(j)), depth);
}

void RemovalTree::expand(std::size_t depth)
{
    if (!mayExpand()) return;
    Node& node = nodes_[depth];
    node.bound.measure(node.Lam, node.gt);
    tryEachRemoval(depth);
    while (incumbent_.removals() - removals(depth) >= 2 && !ended_)
    {
        if (!node.bound.keepForced(node.d2, removals(depth), incumbent_)) return;
        const Eigen::Index j = heaviest(node.bound, incumbent_.removals() - removals(depth));
        node.bound.drop(j);
        removed_.push_back(node.pairs[static_cast<std::size_t>(j)]);
        if (incumbent_.removals() - removals(depth) == 2)
            tryEachLast(depth, j);
        else
            descend(depth, j);
        removed_.pop_back();
    }
}

void RemovalTree::tryEachLast(std::size_t depth, Eigen::Index j)
{
    const Node& node = nodes_[depth];
    const Schur schur(node, j);
    const double d2 = node.d2 - node.bound.gain(j);
    result_.leaves += static_cast<long>(node.bound.open().size());
    result_.d2Evaluations += static_cast<long>(node.bound.open().size());
    for (const Eigen::Index l : node.bound.open())
    {
        const Eigen::Matrix2d Lam_jl = node.Lam.block(j, l);
        const Eigen::Vector2d gt_l =
            node.gt.row(l).matrix().transpose() - Lam_jl.transpose() * schur.step;
        const Eigen::Matrix2d Lam_ll =
            node.Lam.block(l, l) - Lam_jl.transpose() * schur.Sig_jj * Lam_jl;
        accept(node.pairs[static_cast<std::size_t>(l)], d2 - gt_l.dot(Lam_ll.inverse() * gt_l),
               depth + 1);
        if (ended_) return;
    }
}

void RemovalTree::descend(std::size_t depth, Eigen::Index j)
{
    Node& child = nodeAt(depth + 1);
    const Node& node = nodes_[depth];
    const std::vector<Eigen::Index>& open = node.bound.open();
    const auto n = static_cast<Eigen::Index>(open.size());
    const Schur schur(node, j);
    child.d2 = node.d2 - node.bound.gain(j);
    child.pairs.clear();
    if (child.gt.rows() < n)
    {
        child.gt.resize(n, 2);
        child.Lam_j.resize(n, 4);
    }
    for (Eigen::Index l = 0; l < n; ++l)
    {
        const Eigen::Index from = open[static_cast<std::size_t>(l)];
        child.pairs.push_back(node.pairs[static_cast<std::size_t>(from)]);
        const Eigen::Matrix2d Lam_lj = node.Lam.block(from, j);
        child.gt.row(l) = node.gt.row(from) - (Lam_lj * schur.step).transpose().array();
        child.Lam_j.row(l) << Lam_lj(0, 0), Lam_lj(1, 0), Lam_lj(0, 1), Lam_lj(1, 1);
    }
    child.Lam.gather(node.Lam, open);
    for (Eigen::Index k = 0; k < n; ++k)
    {
        const Eigen::Matrix2d K =
            schur.Sig_jj * node.Lam.block(j, open[static_cast<std::size_t>(k)]);
        for (Eigen::Index a = 0; a < 2; ++a)
            for (Eigen::Index b = 0; b < 2; ++b)
                child.Lam.plane(a, b).col(k).tail(n - k) -=
                    K(0, b) * child.Lam_j.col(a).segment(k, n - k) +
                    K(1, b) * child.Lam_j.col(2 + a).segment(k, n - k);
    }
    expand(depth + 1);
}
}  // namespace monoslam
