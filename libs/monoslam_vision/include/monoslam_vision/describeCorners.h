// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "monoslam_vision/PreparedImage.h"
#include "monoslam_vision/export.h"

namespace monoslam
{
/** Places in an image and what they look like, whatever the roll of the camera: OpenCV's ORB descriptors
 *  at scales 1, 0.7 and 0.5. A place may have several rows. */
struct DescribedCorners
{
    std::vector<Eigen::Vector2d> uv_px;  ///< of each row, in the image itself
    std::vector<std::size_t> index;      ///< of each row: which of the places it belongs to
    cv::Mat descriptors;                 ///< a row each, CV_8U
};

/** One known place and where it seems to be. */
struct CornerMatch
{
    std::size_t index = 0;  ///< of the known place
    Eigen::Vector2d uv_px;  ///< in the image seen
};

/** The strongest corners of each scale of an image. */
[[nodiscard]] MONOSLAM_VISION_EXPORT DescribedCorners describeImage(const PreparedImage& image);

/** One place of an image, appended to \p all with an index; nothing is appended where it lies too close
 *  to the border at every scale. */
MONOSLAM_VISION_EXPORT void describePlace(const PreparedImage& image, const Eigen::Vector2d& uv_px,
                                          std::size_t index, DescribedCorners& all);

/** The known places that look like one corner seen and like no other, each at most once. */
[[nodiscard]] MONOSLAM_VISION_EXPORT std::vector<CornerMatch> matchCorners(
    const DescribedCorners& known, const DescribedCorners& seen);
}  // namespace monoslam
