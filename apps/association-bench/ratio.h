// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

namespace monoslam
{
/** With four digits; "-" of nothing. */
[[nodiscard]] inline std::string ratio(long part, long whole)
{
    if (whole == 0) return "-";
    char text[32];
    std::snprintf(text, sizeof text, "%.4f",
                  static_cast<double>(part) / static_cast<double>(whole));
    return text;
}
}  // namespace monoslam
