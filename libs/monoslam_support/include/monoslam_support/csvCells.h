// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>
#include <string>

namespace monoslam
{
/** A number as text, by printf's format for one double. */
[[nodiscard]] inline std::string number(double value, const char* format = "%.9g")
{
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/** A cell of CSV in quotes, those inside doubled (RFC 4180). */
[[nodiscard]] inline std::string quoted(const std::string& text)
{
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}
}  // namespace monoslam
