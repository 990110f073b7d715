// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/chosenAssociator.h"

#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
std::unique_ptr<Associator> chosenAssociator(const mrpt::config::CConfigFileBase& file,
                                             const std::string& fileName)
{
    for (const auto& name : associatorNames())
        if (file.sectionExists("association." + name))
            static_cast<void>(makeAssociator(name, file, fileName));
    ConfigSection section(file, "association", fileName);
    return makeAssociator(section.get("strategy", "hohct"), file, fileName);
}

std::set<std::string> associationSections()
{
    std::set<std::string> sections{"association"};
    for (const auto& name : associatorNames()) sections.insert("association." + name);
    return sections;
}
}  // namespace monoslam
