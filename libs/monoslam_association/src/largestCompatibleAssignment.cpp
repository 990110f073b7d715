// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/largestCompatibleAssignment.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <set>

#include "assignmentOrders.h"
#include "monoslam_association/ConditionalPairs.h"
#include "monoslam_association/assignByJcbb.h"

namespace monoslam
{
namespace
{
/** An improvement smaller than this is rounding. */
constexpr double kMargin = 1e-11;

class RemovalLevels
{
   public:
    RemovalLevels(const AssignmentProblem& problem, AssignmentResult incumbent, long nodeCap)
        : problem_(problem), stack_(problem), best_(std::move(incumbent)), nodesLeft_(nodeCap)
    {
        chosen_.assign(problem.items.size(), -1);
        for (std::size_t i = 0; i < problem.items.size(); ++i)
            if (!problem.items[i].empty()) items_.push_back(i);
        decideDoubtfulFirst();
    }

    AssignmentResult run()
    {
        const auto most = static_cast<long>(items_.size()) - best_.pairs;
        bool found = false;
        for (long i = 0; i <= most && !found && nodesLeft_ >= 0; ++i)
        {
            size_ = static_cast<long>(items_.size()) - i;
            grow(0, i);
            found = best_.pairs == size_;
        }
        best_.proved = nodesLeft_ >= 0;
        return std::move(best_);
    }

   private:
    /** Those that the incumbent leaves out, then those that fit it worst, given all its others. */
    void decideDoubtfulFirst()
    {
        std::vector<double> doubt(problem_.items.size(), std::numeric_limits<double>::infinity());
        const Eigen::Index O = problem_.dimension;
        const JointPairs joint = jointPairs(problem_, best_.chosen);
        const Eigen::MatrixXd Lam =
            joint.S.llt().solve(Eigen::MatrixXd::Identity(joint.nu.size(), joint.nu.size()));
        const Eigen::VectorXd gt = Lam * joint.nu;
        for (std::size_t j = 0; j < joint.items.size(); ++j)
        {
            const Eigen::Index at = O * static_cast<Eigen::Index>(j);
            const Eigen::VectorXd gt_j = gt.segment(at, O);
            doubt[joint.items[j]] = gt_j.dot(Lam.block(at, at, O, O).llt().solve(gt_j));
        }
        std::stable_sort(items_.begin(), items_.end(),
                         [&](std::size_t a, std::size_t b) { return doubt[a] > doubt[b]; });
    }

    /** What the D2 of a better assignment of this level does not exceed. */
    [[nodiscard]] double threshold() const
    {
        const double limit = problem_.limits[static_cast<std::size_t>(size_)];
        if (best_.pairs < size_ || problem_.likelihood) return limit;
        return std::min(limit, best_.d2 - kMargin);
    }

    [[nodiscard]] bool open(const AssignmentPair& pair) const
    {
        return used_.count(pair.use) == 0 && stack_.d2() + stack_.gain(pair).nis <= threshold();
    }

    /** Whether more items than may be removed have no candidate left. */
    [[nodiscard]] bool tooManyAreDead(std::size_t level, long removals) const
    {
        for (std::size_t l = level; l < items_.size(); ++l)
        {
            const auto& item = problem_.items[items_[l]];
            const auto isOpen = [this](const AssignmentPair& pair) { return open(pair); };
            if (std::none_of(item.begin(), item.end(), isOpen) && --removals < 0) return true;
        }
        return false;
    }

    void grow(std::size_t level, long removals)
    {
        if (--nodesLeft_ < 0) return;
        ++best_.nodes;
        if (level == items_.size()) return leaf();
        if (tooManyAreDead(level, removals)) return;
        const std::size_t item = items_[level];
        for (const RankedCandidate& candidate :
             nearestFirst(problem_.items[item], stack_, problem_.likelihood))
        {
            const AssignmentPair& pair = problem_.items[item][candidate.index];
            if (!open(pair) || !stack_.push(pair)) continue;
            used_.insert(pair.use);
            chosen_[item] = static_cast<int>(candidate.index);
            grow(level + 1, removals);
            chosen_[item] = -1;
            used_.erase(pair.use);
            stack_.pop();
        }
        if (removals > 0) grow(level + 1, removals - 1);
    }

    void leaf()
    {
        if (stack_.pairs() != size_ || stack_.d2() > threshold()) return;
        AssignmentResult found = best_;
        found.chosen = chosen_;
        found.pairs = size_;
        found.d2 = stack_.d2();
        found.logDet = stack_.logDet();
        const bool better = best_.pairs < size_ ||
                            found.cost(problem_.likelihood) < best_.cost(problem_.likelihood);
        if (better) best_ = std::move(found);
    }

    const AssignmentProblem& problem_;
    ConditionalPairs stack_;
    AssignmentResult best_;
    long nodesLeft_;
    long size_ = 0;  ///< pairs of the assignments of this level
    std::vector<std::size_t> items_;
    std::set<Eigen::Index> used_;
    std::vector<int> chosen_;
};
}  // namespace

AssignmentResult largestCompatibleAssignment(const AssignmentProblem& problem, long nodeCap)
{
    return RemovalLevels(problem, assignByJcbb(problem, nodeCap), nodeCap).run();
}
}  // namespace monoslam
