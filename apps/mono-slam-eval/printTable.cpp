// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>

#include "Figure.h"

namespace monoslam
{
namespace
{
std::string rounded(const Figure& figure)
{
    if (!std::isfinite(figure.value)) return "-";
    std::ostringstream out;
    out << std::fixed << std::setprecision(figure.decimals) << figure.value;
    return out.str();
}

std::string exact(double value, const std::string& missing)
{
    if (!std::isfinite(value)) return missing;
    std::ostringstream out;
    out << std::setprecision(std::numeric_limits<double>::max_digits10) << value;
    return out.str();
}

std::string quoted(const std::string& text)
{
    std::string result = "\"";
    for (const char c : text)
    {
        if (c == '"' || c == '\\') result += '\\';
        if (static_cast<unsigned char>(c) >= 0x20) result += c;
    }
    return result + "\"";
}
}  // namespace

void printTable(std::ostream& out, const Table& table)
{
    const int labelWidth = 32;
    std::vector<int> widths;
    for (const std::string& name : table.names)
        widths.push_back(std::max(12, static_cast<int>(name.size())) + 2);
    out << std::left << std::setw(labelWidth) << "" << std::right;
    for (std::size_t i = 0; i < table.names.size(); ++i)
        out << std::setw(widths[i]) << table.names[i];
    out << '\n';
    for (std::size_t row = 0; row < table.columns.front().size(); ++row)
    {
        out << std::left << std::setw(labelWidth) << table.columns.front()[row].label << std::right;
        for (std::size_t i = 0; i < table.names.size(); ++i)
            out << "  " << std::setw(widths[i] - 2) << rounded(table.columns[i][row]);
        out << '\n';
    }
}

void printCsv(std::ostream& out, const Table& table)
{
    out << "figure";
    for (const std::string& name : table.names) out << ',' << name;
    out << '\n';
    for (std::size_t row = 0; row < table.columns.front().size(); ++row)
    {
        out << table.columns.front()[row].key;
        for (const auto& column : table.columns) out << ',' << exact(column[row].value, "");
        out << '\n';
    }
}

void printJson(std::ostream& out, const Table& table)
{
    out << "[\n";
    for (std::size_t i = 0; i < table.names.size(); ++i)
    {
        out << "  {\"name\": " << quoted(table.names[i]);
        for (const Figure& figure : table.columns[i])
            out << ",\n   " << quoted(figure.key) << ": " << exact(figure.value, "null");
        out << (i + 1 < table.names.size() ? "},\n" : "}\n");
    }
    out << "]\n";
}
}  // namespace monoslam
