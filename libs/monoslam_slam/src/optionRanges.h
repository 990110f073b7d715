// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
inline constexpr Range kAboveZero{1e-12, 1e12};
inline constexpr Range kFromZero{0.0, 1e12};
inline constexpr Range kRatio{0.0, 1.0};
}  // namespace monoslam
