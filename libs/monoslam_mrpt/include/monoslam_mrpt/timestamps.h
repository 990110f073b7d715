// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/core/Clock.h>

#include <cstdint>
#include <optional>
#include <string>

#include "monoslam_mrpt/export.h"

/** Time as integers, because a double cannot hold today's time in ticks of 100 ns. */
namespace monoslam
{
/** Ticks of 100 ns since the Unix epoch. */
using Ticks = std::int64_t;

[[nodiscard]] MONOSLAM_MRPT_EXPORT mrpt::Clock::time_point clockOf(Ticks ticks);
[[nodiscard]] MONOSLAM_MRPT_EXPORT Ticks ticksOf(mrpt::Clock::time_point time);

/** The nearest double [s]. */
[[nodiscard]] MONOSLAM_MRPT_EXPORT double seconds(Ticks ticks);

/** "1305031229.528748" without a detour over double; digits below 100 ns are rounded. Exponents are
 *  understood as well. \return nothing if the text is not a number of seconds */
[[nodiscard]] MONOSLAM_MRPT_EXPORT std::optional<Ticks> parseSeconds(const std::string& text);

/** "1403636579763555584", rounded to 100 ns. */
[[nodiscard]] MONOSLAM_MRPT_EXPORT std::optional<Ticks> parseNanoseconds(const std::string& text);
}  // namespace monoslam
