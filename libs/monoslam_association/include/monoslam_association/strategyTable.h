// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "monoslam_association/export.h"

namespace monoslam
{
/** What every registered strategy uses with its default options: Table 1 of Soto-Alvarez and
 *  Honkamaa, as Markdown. */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT std::string strategyTable();
}  // namespace monoslam
