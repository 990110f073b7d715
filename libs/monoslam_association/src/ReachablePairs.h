// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

namespace monoslam
{
/** Puts a value into a falling list in place of its last one. */
inline void insertFalling(std::vector<double>& falling, double value)
{
    std::size_t at = falling.size() - 1;
    for (; at > 0 && falling[at - 1] < value; --at) falling[at] = falling[at - 1];
    falling[at] = value;
}

/** Pairs that may be among removals that gain enough. */
class ReachablePairs
{
   public:
    /** Sets this close to a threshold are not excluded: bounds are rounded too. */
    static constexpr double kMargin = 1e-9;

    void clear(Eigen::Index n)
    {
        marks_.assign(static_cast<std::size_t>(n), 0);
        any_ = false;
    }

    /** Marks what may be among x pairs that gain \p needed in all, pair j at most \p values(j). */
    void mark(const Eigen::Ref<const Eigen::ArrayXd>& values, Eigen::Index x, double needed);

    [[nodiscard]] bool any() const { return any_; }
    [[nodiscard]] bool operator[](Eigen::Index j) const
    {
        return marks_[static_cast<std::size_t>(j)] != 0;
    }

   private:
    std::vector<char> marks_;
    std::vector<double> largest_;
    bool any_ = false;
};
}  // namespace monoslam
