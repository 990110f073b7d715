// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include "edgeQuad.h"

namespace monoslam
{
[[nodiscard]] double perimeterOf(const Quad& quad);

/** Whether the inside of rough corners may be dark against what is around: spares most fits. */
[[nodiscard]] bool roughlyDark(const cv::Mat& image, const Quad& quad);

/** How much the sides of a dark filled rectangle tell about where they are: squared contrast of the
 *  weakest times the length of all [px]. A printed target has strong edges; tiles and shadows may
 *  be larger.
 *  \return 0 if it is not less than half as bright as its surroundings, or not filled */
[[nodiscard]] double evidenceOfRectangle(const cv::Mat& image, const EdgeQuad& edges);
}  // namespace monoslam
