// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace monoslam
{
/** The last line of a text file that is not blank, as it would stand on a terminal; empty where
 *  there is none. */
[[nodiscard]] std::string lastLineOf(const std::string& path);
}  // namespace monoslam
