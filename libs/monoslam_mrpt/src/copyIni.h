// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/config/CConfigFileMemory.h>

namespace monoslam
{
/** All sections and keys of any kind of ini, to be kept or changed. */
[[nodiscard]] mrpt::config::CConfigFileMemory copyOf(const mrpt::config::CConfigFileBase& ini);
}  // namespace monoslam
