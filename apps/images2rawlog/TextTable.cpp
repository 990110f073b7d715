// SPDX-License-Identifier: BSD-3-Clause
#include "TextTable.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace monoslam
{
void TableRow::fail(const std::string& message) const
{
    throw std::runtime_error(place + ": " + message);
}

double TableRow::number(std::size_t column) const
{
    if (column >= words.size()) fail("too few columns");
    char* end = nullptr;
    const double value = std::strtod(words[column].c_str(), &end);
    if (end != words[column].c_str() + words[column].size()) fail("not a number: " + words[column]);
    return value;
}

std::vector<TableRow> readTable(const std::string& file)
{
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error(file + ": cannot be read");
    std::vector<TableRow> rows;
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number)
    {
        TableRow row;
        row.place = file + ":" + std::to_string(number);
        row.commas = line.find(',') != std::string::npos;
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        for (std::string word; words >> word;) row.words.push_back(word);
        if (!row.words.empty() && row.words[0][0] != '#') rows.push_back(std::move(row));
    }
    return rows;
}
}  // namespace monoslam
