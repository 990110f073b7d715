// SPDX-License-Identifier: BSD-3-Clause
#include "resizeBelief.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace monoslam
{
namespace
{
using camera_state::kPoseSize;
using camera_state::kSize;

/** Keeps the listed blocks (offset, length), sorted by offset, and closes the gaps. */
void keepBlocks(Belief& belief, const std::vector<std::pair<Eigen::Index, Eigen::Index>>& blocks)
{
    Eigen::Index size = 0;
    for (const auto& block : blocks) size += block.second;
    Eigen::VectorXd x(size);
    Eigen::MatrixXd P(size, size);
    Eigen::Index row = 0;
    for (const auto& [rowOffset, rows] : blocks)
    {
        x.segment(row, rows) = belief.x.segment(rowOffset, rows);
        Eigen::Index column = 0;
        for (const auto& [columnOffset, columns] : blocks)
        {
            P.block(column, row, columns, rows) =
                belief.P.block(columnOffset, rowOffset, columns, rows);
            column += columns;
        }
        row += rows;
    }
    belief.x = std::move(x);
    belief.P = std::move(P);
}

}  // namespace

void grow(Belief& belief, Eigen::Index extra)
{
    const Eigen::Index n = belief.size();
    belief.x.conservativeResize(n + extra);
    belief.P.conservativeResize(n + extra, n + extra);
    belief.P.rightCols(extra).setZero();
    belief.P.bottomRows(extra).setZero();
}

void compact(Belief& belief)
{
    std::vector<std::pair<Eigen::Index, Eigen::Index>> blocks{{0, kSize}};
    for (const auto& slot : belief.landmarks) blocks.emplace_back(slot.offset, slot.size());
    for (const auto& slot : belief.clones) blocks.emplace_back(slot.offset, kPoseSize);
    std::sort(blocks.begin(), blocks.end());
    keepBlocks(belief, blocks);

    const auto moved = [&blocks](Eigen::Index offset)
    {
        Eigen::Index at = 0;
        for (const auto& block : blocks)
        {
            if (block.first == offset) return at;
            at += block.second;
        }
        throw std::logic_error("compact: a slot without a block");
    };
    for (auto& slot : belief.landmarks) slot.offset = moved(slot.offset);
    for (auto& slot : belief.clones) slot.offset = moved(slot.offset);
}
}  // namespace monoslam
