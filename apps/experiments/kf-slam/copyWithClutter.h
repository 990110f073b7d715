// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace monoslam
{
/** Where false observations are. */
enum class Clutter
{
    Uniform,    ///< anywhere in the sensor's range and field of view, besides the true ones
    Echo,       ///< within 0.6 m and 0.06 rad of a true one, besides it
    Displaced,  ///< there, instead of it
};

/** Copies a rawlog of pairs of actions and observations, with false ones among the bearings and
 *  ranges, in random order. \param mean  false observations a frame, Poisson
 *  \throw std::runtime_error naming the file */
void copyWithClutter(const std::string& from, const std::string& to, Clutter kind, double mean,
                     unsigned seed);
}  // namespace monoslam
