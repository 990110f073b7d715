// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_association/SequentialUpdate.h"
#include "monoslam_association/export.h"

namespace monoslam
{
class ConfigSection;

/** What a measurement is to tell about. */
enum class InformationTarget
{
    State,  ///< camera and map: a function of the ellipse's area
    Pose,   ///< the camera's position and orientation alone
};

/** mi_target = state | pose. */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT InformationTarget
informationTargetFrom(ConfigSection& section);

/** How much an open landmark's measurement tells, and for what work. */
struct MeasurementEfficiency
{
    std::size_t landmark = 0;    ///< index in SequentialUpdate::landmarks()
    double bits = 0.0;           ///< M_i
    double bitsPerPixel2 = 0.0;  ///< M_i / A_i, A_i = pi gate sqrt|S_i|
};

/** Of every open landmark, in their order. \see Davison, "Active search for real-time vision",
 *  ICCV 2005 */
MONOSLAM_ASSOCIATION_EXPORT void listEfficiencies(const SequentialUpdate& update,
                                                  InformationTarget target, double gate,
                                                  std::vector<MeasurementEfficiency>& list);
}  // namespace monoslam
