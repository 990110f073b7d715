// SPDX-License-Identifier: BSD-3-Clause
#include "CsvFile.h"

#include <algorithm>
#include <stdexcept>

namespace monoslam
{
namespace
{
std::vector<std::string> split(const std::string& line)
{
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line)
    {
        if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            cells.emplace_back();
        else if (c != '\r')
            cells.back() += c;
    }
    return cells;
}
}  // namespace

CsvFile::CsvFile(const std::string& fileName) : fileName_(fileName), stream_(fileName)
{
    std::string line;
    if (!std::getline(stream_, line)) throw std::invalid_argument(fileName + ": cannot be read");
    header_ = split(line);
}

bool CsvFile::next()
{
    std::string line;
    if (!std::getline(stream_, line)) return false;
    ++line_;
    cells_ = split(line);
    if (cells_.size() != header_.size())
        throw std::invalid_argument(fileName_ + ":" + std::to_string(line_) + ": has " +
                                    std::to_string(cells_.size()) + " cells, the header " +
                                    std::to_string(header_.size()));
    return true;
}

const std::string& CsvFile::text(const std::string& column) const
{
    const auto at = std::find(header_.begin(), header_.end(), column);
    if (at == header_.end()) throw std::invalid_argument(fileName_ + ": no column " + column);
    return cells_[static_cast<std::size_t>(at - header_.begin())];
}

double CsvFile::number(const std::string& column) const
{
    const std::string& cell = text(column);
    try
    {
        std::size_t used = 0;
        const double value = std::stod(cell, &used);
        if (used == cell.size()) return value;
    }
    catch (const std::exception&)
    {
    }
    throw std::invalid_argument(fileName_ + ":" + std::to_string(line_) + ": " + column +
                                ": no number: '" + cell + "'");
}
}  // namespace monoslam
