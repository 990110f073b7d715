// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/assignByJcbb.h"

#include <set>

#include "assignmentOrders.h"
#include "monoslam_association/ConditionalPairs.h"

namespace monoslam
{
namespace
{
class Jcbb
{
   public:
    Jcbb(const AssignmentProblem& problem, long nodeCap)
        : problem_(problem), nodeCap_(nodeCap), stack_(problem)
    {
        best_.chosen.assign(problem.items.size(), -1);
        chosen_ = best_.chosen;
        order_ = nearestFirst(problem, stack_);
        for (std::size_t i = 0; i < order_.size(); ++i)
            if (!order_[i].empty()) items_.push_back(i);
    }

    AssignmentResult run()
    {
        if (!nearestOfAllAreCompatible()) branch(0);
        return std::move(best_);
    }

   private:
    [[nodiscard]] double limit() const
    {
        return problem_.limits[static_cast<std::size_t>(stack_.pairs())];
    }

    bool push(std::size_t level, std::size_t candidate)
    {
        const std::size_t item = items_[level];
        const AssignmentPair& pair = problem_.items[item][candidate];
        if (used_.count(pair.use) > 0 || !stack_.push(pair)) return false;
        used_.insert(pair.use);
        chosen_[item] = static_cast<int>(candidate);
        return true;
    }

    void pop(std::size_t level)
    {
        const std::size_t item = items_[level];
        used_.erase(problem_.items[item][static_cast<std::size_t>(chosen_[item])].use);
        chosen_[item] = -1;
        stack_.pop();
    }

    bool nearestOfAllAreCompatible()
    {
        std::size_t level = 0;
        while (level < items_.size() && push(level, order_[items_[level]].front().index)) ++level;
        const bool compatible = level == items_.size() && stack_.d2() <= limit();
        if (compatible) keepBest();
        while (level > 0) pop(--level);
        return compatible && !problem_.likelihood;
    }

    void keepBest()
    {
        best_.chosen = chosen_;
        best_.pairs = stack_.pairs();
        best_.d2 = stack_.d2();
        best_.logDet = stack_.logDet();
    }

    [[nodiscard]] bool isBetter() const
    {
        if (stack_.pairs() != best_.pairs) return stack_.pairs() > best_.pairs;
        const double logDet = problem_.likelihood ? stack_.logDet() : 0.0;
        return stack_.d2() + logDet < best_.cost(problem_.likelihood);
    }

    /** \param undecided  items that may still be paired */
    [[nodiscard]] bool canBeatBest(std::size_t undecided) const
    {
        const long pairs = stack_.pairs() + static_cast<long>(undecided);
        if (pairs != best_.pairs) return pairs > best_.pairs;
        return problem_.likelihood || stack_.d2() < best_.d2;
    }

    void branch(std::size_t level)
    {
        if (best_.nodes >= nodeCap_)
        {
            best_.proved = false;
            if (isBetter()) keepBest();
            return;
        }
        ++best_.nodes;
        if (level == items_.size())
        {
            if (isBetter()) keepBest();
            return;
        }
        const std::size_t undecided = items_.size() - level - 1;
        for (const RankedCandidate& candidate : order_[items_[level]])
        {
            if (!push(level, candidate.index)) continue;
            if (stack_.d2() <= limit() && canBeatBest(undecided)) branch(level + 1);
            pop(level);
        }
        if (canBeatBest(undecided)) branch(level + 1);
    }

    const AssignmentProblem& problem_;
    long nodeCap_;
    ConditionalPairs stack_;
    CandidateOrder order_;
    std::vector<std::size_t> items_;  ///< that have a candidate
    std::set<Eigen::Index> used_;
    std::vector<int> chosen_;
    AssignmentResult best_;
};
}  // namespace

AssignmentResult assignByJcbb(const AssignmentProblem& problem, long nodeCap)
{
    return Jcbb(problem, nodeCap).run();
}
}  // namespace monoslam
