// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace monoslam
{
/** Numbers and ascending ranges, separated by spaces or commas: "1-3, 7" is 1 2 3 7.
 *  \return nothing if there is none, one is no such number, or one comes twice */
[[nodiscard]] std::optional<std::vector<unsigned>> parseSeeds(const std::string& text);
}  // namespace monoslam
