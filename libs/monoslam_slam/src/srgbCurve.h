// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace monoslam
{
/** A light and how fast it grows with the grey value. */
struct Light
{
    double value;
    double slope;
};

/** Light of the grey value v by IEC 61966-2-1, both 0 .. 1; outside it goes on as the formula does. */
[[nodiscard]] Light srgbByPower(double v);

/** The same from a table, to 1e-9 in value and 1e-7 in slope: the power would be most of the time of a
 *  fit of edges. */
[[nodiscard]] Light srgb(double v);
}  // namespace monoslam
