// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "NodeAllowance.h"
#include "monoslam_association/jointCompatibility.h"
#include "monoslam_association/largestCompatibleSubset.h"

namespace monoslam
{
/** The best set that the searches of one problem know. */
class SubsetIncumbent
{
   public:
    /** An improvement smaller than this is rounding. */
    static constexpr double kMargin = 1e-11;

    explicit SubsetIncumbent(const SubsetProblem& problem)
        : limits_(problem.limits), size_(problem.pairs())
    {
        for (Eigen::Index j = 0; j < size_; ++j) removed_.push_back(j);
    }

    /** A better set with i removals has a D2 of at most this; non-increasing in i. */
    [[nodiscard]] double threshold(Eigen::Index i) const
    {
        if (i < size_) return limits_[static_cast<std::size_t>(i)];
        return i == size_ ? d2_ - kMargin : -std::numeric_limits<double>::infinity();
    }
    void replace(std::vector<Eigen::Index> removed, double d2)
    {
        removed_ = std::move(removed);
        size_ = static_cast<Eigen::Index>(removed_.size());
        d2_ = d2;
    }
    [[nodiscard]] Eigen::Index removals() const { return size_; }
    [[nodiscard]] double d2() const { return d2_; }
    [[nodiscard]] const std::vector<Eigen::Index>& removed() const { return removed_; }

   private:
    const std::vector<double>& limits_;
    Eigen::Index size_;
    std::vector<Eigen::Index> removed_;
    double d2_ = 0.0;
};

/** Each improves the incumbent and counts in the result. \return true if its answer is proved. */
void searchGreedily(const SubsetProblem& problem, const DowndatingD2& whole,
                    SubsetIncumbent& incumbent, SubsetResult& result);
bool searchAsPrinted(const SubsetProblem& problem, double maxSubsets, SubsetIncumbent& incumbent,
                     SubsetResult& result);
bool searchByDowndating(const SubsetProblem& problem, const DowndatingD2& whole, double maxSubsets,
                        SubsetIncumbent& incumbent, SubsetResult& result);
bool searchByPrefixes(const SubsetProblem& problem, const DowndatingD2& whole,
                      NodeAllowance& allowance, SubsetIncumbent& incumbent, SubsetResult& result);
bool searchByRemovals(const DowndatingD2& whole, NodeAllowance& allowance,
                      SubsetIncumbent& incumbent, SubsetResult& result);
bool searchByReinsertions(const DowndatingD2& whole, NodeAllowance& allowance,
                          SubsetIncumbent& incumbent, SubsetResult& result);
/** Greedy, then the three above in an order that its answer suggests. */
bool searchByPortfolio(const SubsetProblem& problem, const DowndatingD2& whole,
                       NodeAllowance& allowance, SubsetIncumbent& incumbent, SubsetResult& result);
}  // namespace monoslam
