// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/registerMrptAssociators.h"

#include "JcbbMrpt.h"

namespace monoslam
{
void registerMrptAssociators()
{
    registerAssociator("jcbb_mrpt",
                       [](const mrpt::config::CConfigFileBase& file, const std::string& fileName)
                       {
                           return std::make_unique<JcbbMrpt>(
                               BatchOptions::from(file, fileName),
                               ConfigSection(file, "association.jcbb_mrpt", fileName));
                       });
}
}  // namespace monoslam
