// SPDX-License-Identifier: BSD-3-Clause
#include "problemCsv.h"

#include "monoslam_support/csvCells.h"

namespace monoslam
{
namespace
{
/** Landmarks whose pair was found and rejected, separated by spaces. */
std::string rejectedIds(const Solution& solution)
{
    std::string ids;
    for (const Association& a : solution.correction.associations)
        if (a.fate == Fate::Rejected)
            ids.append(ids.empty() ? "" : " ").append(std::to_string(a.id));
    return ids;
}
}  // namespace

std::string problemHead()
{
    return "file,frame,strategy,pairs,accepted,rejected,searched,d2,nodes,leaves,d2_evaluations,"
           "proved,capped,truth_known,right,present,associate_ms,total_ms,rejected_ids\n";
}

std::string problemLine(const std::string& file, long frame, const std::string& strategy,
                        const Solution& s)
{
    const AssociationCounters& c = s.correction.counters;
    std::string line = quoted(file) + "," + std::to_string(frame) + "," + strategy;
    for (const long count : {c.pairs, s.accepted, s.rejected, c.jointSearches})
        line += "," + std::to_string(count);
    line += "," + number(s.d2);
    for (const long count : {c.nodes, c.leaves, c.d2Evaluations, c.provedOptimal ? 1L : 0L,
                             c.capped > 0 ? 1L : 0L, s.truthKnown ? 1L : 0L, s.right, s.present})
        line += "," + std::to_string(count);
    return line + "," + number(s.associate_ms) + "," + number(s.total_ms) + "," + rejectedIds(s) +
           "\n";
}
}  // namespace monoslam
