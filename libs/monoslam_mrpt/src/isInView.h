// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservationBearingRange.h>

#include <cmath>

namespace monoslam
{
/** Parts of range and field of view outside of which a landmark may well be missed. */
inline constexpr double kSureRange = 0.95;
inline constexpr double kSureView = 0.9;

/** Whether the sensor cannot but see what it is predicted to measure: range and angles. */
template <typename Measurement>
bool isInView(const mrpt::obs::CObservationBearingRange& sensor, const Measurement& h)
{
    const double halfView_rad[] = {0.5 * sensor.fieldOfView_yaw, 0.5 * sensor.fieldOfView_pitch};
    bool inside = h[0] < kSureRange * sensor.maxSensorDistance;
    for (int angle = 1; angle < h.rows(); ++angle)
        inside = inside && std::abs(h[angle]) < kSureView * halfView_rad[angle - 1];
    return inside;
}
}  // namespace monoslam
