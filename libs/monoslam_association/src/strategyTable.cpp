// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/strategyTable.h"

#include <mrpt/config/CConfigFileMemory.h>

#include "monoslam_association/Associator.h"

namespace monoslam
{
std::string strategyTable()
{
    std::string table =
        "| strategy | spatial | appearance | several candidates | hypotheses within a frame | "
        "between frames |\n|---|---|---|---|---|---|\n";
    for (const std::string& name : associatorNames())
    {
        const AssociatorTraits traits =
            makeAssociator(name, mrpt::config::CConfigFileMemory(std::string()))->traits();
        table += "| " + name + " |";
        for (const bool has : {traits.spatial, traits.appearance, traits.multipleCandidates,
                               traits.hypothesesWithinFrame, traits.hypothesesBetweenFrames})
            table += has ? " yes |" : " - |";
        table += "\n";
    }
    return table;
}
}  // namespace monoslam
