// SPDX-License-Identifier: BSD-3-Clause
#include "AssociationCsv.h"

#include <cstdio>

namespace monoslam
{
namespace
{
const char* nameOf(Fate fate)
{
    switch (fate)
    {
        case Fate::Matched:
            return "matched";
        case Fate::Rejected:
            return "rejected";
        case Fate::NotFound:
            return "not_found";
        default:
            return "not_searched";
    }
}

std::string lineOf(long frame, const Association& a)
{
    char text[160];
    std::snprintf(text, sizeof text, "%ld,%ld,%s,%.2f,%.2f,", frame, static_cast<long>(a.id),
                  nameOf(a.fate), a.h.x(), a.h.y());
    std::string line = text;
    const bool hasPixel = a.fate == Fate::Matched || a.fate == Fate::Rejected;
    if (hasPixel)
        std::snprintf(text, sizeof text, "%.2f,%.2f,%.4f,%.4g\n", a.z.x(), a.z.y(), a.score, a.nis);
    return line + (hasPixel ? text : ",,,\n");
}
}  // namespace

AssociationCsv::AssociationCsv(const std::string& folder) : file_(folder + "/associations.csv")
{
    file_.write("index,id,fate,h_u_px,h_v_px,z_u_px,z_v_px,score,nis\n");
}

void AssociationCsv::write(const FrameReport& report)
{
    std::string lines;
    for (const Association& a : report.associations) lines += lineOf(report.index, a);
    file_.write(lines);
}
}  // namespace monoslam
