// SPDX-License-Identifier: BSD-3-Clause
#include "Figures.h"

#include <algorithm>

namespace monoslam
{
void Figures::add(const Solution& solution)
{
    const AssociationCounters& counters = solution.correction.counters;
    ++problems;
    accepted += solution.accepted;
    right += solution.right;
    present += solution.present;
    jointlyCorrect += solution.jointlyCorrect() ? 1 : 0;
    complete += solution.complete() ? 1 : 0;
    nodes += counters.nodes;
    d2Evaluations += counters.d2Evaluations;
    notProved += counters.provedOptimal ? 0 : 1;
    capped += counters.capped > 0 ? 1 : 0;
    associate_ms.push_back(solution.associate_ms);
    total_ms.push_back(solution.total_ms);
}

void Figures::add(const Figures& others)
{
    problems += others.problems;
    accepted += others.accepted;
    right += others.right;
    present += others.present;
    jointlyCorrect += others.jointlyCorrect;
    complete += others.complete;
    nodes += others.nodes;
    d2Evaluations += others.d2Evaluations;
    notProved += others.notProved;
    capped += others.capped;
    associate_ms.insert(associate_ms.end(), others.associate_ms.begin(), others.associate_ms.end());
    total_ms.insert(total_ms.end(), others.total_ms.begin(), others.total_ms.end());
}

double quantile(std::vector<double> values, double q)
{
    if (values.empty()) return 0.0;
    const auto k = static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + k, values.end());
    return values[static_cast<std::size_t>(k)];
}
}  // namespace monoslam
