// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace monoslam
{
/** What stands between spaces and commas. */
[[nodiscard]] std::vector<std::string> splitWords(std::string text);
}  // namespace monoslam
