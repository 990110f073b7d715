// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "runGrid.h"

namespace monoslam
{
/** A line a cell and strategy. */
[[nodiscard]] std::string csvOf(const std::vector<Cell>& cells,
                                const std::vector<std::string>& strategies);

/** Markdown: a table for every number of landmarks and of candidates, over all numbers of absent
 *  landmarks. Of candidates only one and three, if there are any such cells. */
[[nodiscard]] std::string tablesOf(const std::vector<Cell>& cells,
                                   const std::vector<std::string>& strategies);
}  // namespace monoslam
