// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_filter/FilterEngine.h"
#include "monoslam_mrpt/export.h"
#include "monoslam_slam/MonoSlamOptions.h"

namespace monoslam
{
/** The filter that [filter] engine names. \throw std::invalid_argument if it is not built in */
[[nodiscard]] MONOSLAM_MRPT_EXPORT FilterEngine makeEngine(EngineName name);
}  // namespace monoslam
