// SPDX-License-Identifier: BSD-3-Clause
#include "ReachablePairs.h"

#include <algorithm>
#include <numeric>

namespace monoslam
{
void ReachablePairs::mark(const Eigen::Ref<const Eigen::ArrayXd>& values, Eigen::Index x,
                          double needed)
{
    if (x > values.size()) return;
    needed -= kMargin;
    largest_.assign(static_cast<std::size_t>(x), 0.0);
    for (const double value : values)
        if (value > largest_.back()) insertFalling(largest_, value);
    const double last = largest_.back();
    const double others = std::accumulate(largest_.begin(), largest_.end() - 1, 0.0);
    if (others + last < needed) return;
    any_ = true;
    for (Eigen::Index j = 0; j < values.size(); ++j)
        if (others + std::min(values(j), last) >= needed) marks_[static_cast<std::size_t>(j)] = 1;
}
}  // namespace monoslam
