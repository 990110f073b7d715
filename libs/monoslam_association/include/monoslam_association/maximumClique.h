// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_association/export.h"

namespace monoslam
{
struct CliqueResult
{
    std::vector<std::size_t> vertices;  ///< ascending
    bool proved = true;                 ///< false: the node cap ended the search
    long nodes = 0;
};

/** Largest set of vertices that are all adjacent: Bron-Kerbosch with pivoting, cut where even all
 *  vertices left would not beat the best. Among equals the first found in vertex order.
 *  \param adjacent  symmetric; the diagonal does not count
 *  \param nodeCap  then the best so far, which begins with a greedy one
 *  \see Bron, Kerbosch, "Algorithm 457", CACM 1973 */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT CliqueResult
maximumClique(const std::vector<std::vector<bool>>& adjacent, long nodeCap);
}  // namespace monoslam
