// SPDX-License-Identifier: BSD-3-Clause
#include "solveFiles.h"

#include <cstdio>
#include <stdexcept>

#include "monoslam_association/recordedFrameFile.h"
#include "monoslam_eval/solveProblem.h"
#include "problemCsv.h"
#include "ratio.h"

namespace monoslam
{
namespace
{
void printLine(const std::string& name, const Solution& s)
{
    const AssociationCounters& c = s.correction.counters;
    std::printf("| %s | %ld | %ld | ", name.c_str(), s.accepted, s.rejected);
    if (s.truthKnown)
        std::printf("%s | %s | ", ratio(s.right, s.accepted).c_str(),
                    ratio(s.right, s.present).c_str());
    else
        std::printf("- | - | ");
    std::printf("%.4f | %ld | %ld | %.3f | %.3f | %s | %s |\n", s.d2, c.nodes, c.d2Evaluations,
                s.associate_ms, s.total_ms, c.provedOptimal ? "-" : "yes",
                c.capped > 0 ? "yes" : "-");
}

void printHead(const std::string& file, const RecordedFrame& frame)
{
    std::printf("\n%s: frame %ld, %zu landmarks, %zu beliefs\n\n", file.c_str(), frame.index,
                frame.landmarks.size(), frame.mixture.size());
    std::puts(
        "| strategy | pairs | rejected | precision | recall | D2 | nodes | D2 evaluations | "
        "associate [ms] | total [ms] | not proved | capped |\n"
        "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
}

Solution solve(const NamedAssociator& strategy, const std::string& file, const RecordedFrame& frame,
               unsigned seed)
{
    try
    {
        return solveProblem(*strategy.associator, frame, seed);
    }
    catch (const std::exception& error)
    {
        throw std::runtime_error(file + ": " + strategy.name + ": " + error.what());
    }
}
}  // namespace

std::string solveFiles(const Arguments& arguments, const Strategies& strategies)
{
    const std::vector<NamedAssociator> made = strategies.make();
    std::string csv = problemHead();
    for (const std::string& file : arguments.files)
    {
        const RecordedFrame frame = readRecordedFrame(file);
        if (arguments.csv.empty()) printHead(file, frame);
        for (const NamedAssociator& strategy : made)
        {
            const Solution solution = solve(strategy, file, frame, arguments.seed);
            if (arguments.csv.empty()) printLine(strategy.name, solution);
            csv += problemLine(file, frame.index, strategy.name, solution);
        }
    }
    return csv;
}
}  // namespace monoslam
