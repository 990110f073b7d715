// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
/** The keys with a dot, "section.key = value", as settings of mono-slam's --set.
 *  \throw std::invalid_argument naming one that a batch decides by keys of its own */
[[nodiscard]] std::vector<std::string> readSettings(ConfigSection& section);
}  // namespace monoslam
