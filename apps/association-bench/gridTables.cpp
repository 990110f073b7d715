// SPDX-License-Identifier: BSD-3-Clause
#include "gridTables.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <utility>

#include "ratio.h"

namespace monoslam
{
namespace
{
constexpr const char* kColumns =
    "landmarks,candidates,absent,strategy,problems,precision,recall,jointly_correct,complete,"
    "nodes_mean,d2_evaluations_mean,associate_ms_median,associate_ms_max,total_ms_median,"
    "total_ms_max,not_proved,capped\n";

constexpr const char* kHead =
    "| strategy | precision | recall | jointly correct | complete | nodes | D2 evaluations | "
    "associate, median [ms] | 99 % [ms] | worst [ms] | total, median [ms] | not proved | capped |\n"
    "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";

std::string number(double value, const char* format)
{
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

double mean(long sum, long count)
{
    return static_cast<double>(sum) / static_cast<double>(count);
}

std::string csvLine(const Figures& f)
{
    const auto share = [](const std::string& text) { return text == "-" ? "nan" : text; };
    std::string line = std::to_string(f.problems) + "," + share(ratio(f.right, f.accepted)) + "," +
                       share(ratio(f.right, f.present)) + "," + std::to_string(f.jointlyCorrect) +
                       "," + std::to_string(f.complete);
    for (const double value : {mean(f.nodes, f.problems), mean(f.d2Evaluations, f.problems),
                               quantile(f.associate_ms, 0.5), quantile(f.associate_ms, 1.0),
                               quantile(f.total_ms, 0.5), quantile(f.total_ms, 1.0)})
        line += "," + number(value, "%.6g");
    return line + "," + std::to_string(f.notProved) + "," + std::to_string(f.capped) + "\n";
}

std::string tableLine(const std::string& strategy, const Figures& f)
{
    std::string line = "| " + strategy + " | " + ratio(f.right, f.accepted) + " | " +
                       ratio(f.right, f.present) + " | " + ratio(f.jointlyCorrect, f.problems) +
                       " | " + ratio(f.complete, f.problems) + " | " +
                       number(mean(f.nodes, f.problems), "%.1f") + " | " +
                       number(mean(f.d2Evaluations, f.problems), "%.1f") + " | ";
    for (const double q : {0.5, 0.99, 1.0})
        line += number(quantile(f.associate_ms, q), "%.3f") + " | ";
    return line + number(quantile(f.total_ms, 0.5), "%.3f") + " | " + std::to_string(f.notProved) +
           " | " + std::to_string(f.capped) + " |\n";
}

bool shown(const std::vector<Cell>& cells, int candidates)
{
    const auto isShort = [](int c) { return c == 1 || c == 3; };
    const bool any = std::any_of(cells.begin(), cells.end(),
                                 [&](const Cell& cell) { return isShort(cell.shape.candidates); });
    return !any || isShort(candidates);
}
}  // namespace

std::string csvOf(const std::vector<Cell>& cells, const std::vector<std::string>& strategies)
{
    std::string csv = kColumns;
    for (const Cell& cell : cells)
        for (std::size_t s = 0; s < strategies.size(); ++s)
        {
            const ProblemShape& shape = cell.shape;
            csv += std::to_string(shape.landmarks) + "," + std::to_string(shape.candidates) + "," +
                   std::to_string(shape.absent) + "," + strategies[s] + "," +
                   csvLine(cell.figures[s]);
        }
    return csv;
}

std::string tablesOf(const std::vector<Cell>& cells, const std::vector<std::string>& strategies)
{
    std::map<std::pair<int, int>, std::vector<Figures>> pooled;
    for (const Cell& cell : cells)
    {
        if (!shown(cells, cell.shape.candidates)) continue;
        auto& figures = pooled[{cell.shape.landmarks, cell.shape.candidates}];
        figures.resize(strategies.size());
        for (std::size_t s = 0; s < strategies.size(); ++s) figures[s].add(cell.figures[s]);
    }
    std::string text;
    for (const auto& [shape, figures] : pooled)
    {
        text += "\n### m = " + std::to_string(shape.first) + ", " + std::to_string(shape.second) +
                (shape.second == 1 ? " candidate" : " candidates") + ": " +
                std::to_string(figures.front().problems) + " problems\n\n" + kHead;
        for (std::size_t s = 0; s < strategies.size(); ++s)
            text += tableLine(strategies[s], figures[s]);
    }
    return text;
}
}  // namespace monoslam
