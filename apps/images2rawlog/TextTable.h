// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace monoslam
{
/** One line of a text file, split at blanks or commas. */
struct TableRow
{
    std::vector<std::string> words;
    std::string place;  ///< "file:line"
    bool commas = false;

    /** \throw std::runtime_error if the word is missing or no number */
    [[nodiscard]] double number(std::size_t column) const;
    [[noreturn]] void fail(const std::string& message) const;
};

/** All lines but empty ones and those that start with '#'. \throw std::runtime_error */
[[nodiscard]] std::vector<TableRow> readTable(const std::string& file);
}  // namespace monoslam
