// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/types.hpp>
#include <string>
#include <vector>

namespace monoslam
{
/** Outline of the moving object in every frame [px]. */
struct ObjectPolygons
{
    std::vector<std::vector<cv::Point2f>> outlines;
    long firstMoving = 0;  ///< frame from which on the object moves

    [[nodiscard]] bool contains(long frame, double u, double v) const;
};

/** Reads object_polygon.txt and object_motion.txt of a sequence.
 *  \throw std::runtime_error naming the file that is missing or damaged */
[[nodiscard]] ObjectPolygons readObjectPolygons(const std::string& folder);
}  // namespace monoslam
