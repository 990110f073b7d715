// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "monoslam_support/export.h"

namespace mrpt::config
{
class CConfigFileMemory;
}

namespace monoslam
{
/** Replaces the content of \p ini by that of a file, then by the settings of a command line.
 *  \param settings "section.key=value" each; the name is split at its last dot
 *  \throw std::runtime_error if the file cannot be read, std::invalid_argument naming a setting
 *  without section, key or "=" */
MONOSLAM_SUPPORT_EXPORT void readIni(const std::string& fileName,
                                     const std::vector<std::string>& settings,
                                     mrpt::config::CConfigFileMemory& ini);

/** The settings alone, on top of what \p ini has. \throw std::invalid_argument as above */
MONOSLAM_SUPPORT_EXPORT void applySettings(const std::vector<std::string>& settings,
                                           mrpt::config::CConfigFileMemory& ini);
/** \throw std::invalid_argument naming the file, the first section that is not known, and those that
 *  are */
MONOSLAM_SUPPORT_EXPORT void rejectUnknownSections(const mrpt::config::CConfigFileMemory& ini,
                                                   const std::set<std::string>& known,
                                                   const std::string& fileName);
}  // namespace monoslam
