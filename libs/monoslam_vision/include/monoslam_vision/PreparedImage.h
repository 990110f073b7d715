// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "monoslam_vision/export.h"

namespace monoslam
{
/** One frame's image, made ready once: smoothed, as a pyramid, with integral images. */
struct PreparedImage
{
    std::vector<cv::Mat> levels;  ///< CV_8UC1, smoothed; level k has 1/2^k of the size
    cv::Mat sum;                  ///< integral of level 0, CV_32S
    cv::Mat squareSum;            ///< integral of its squares, CV_64F
    int width_px = 0;
    int height_px = 0;
};

/** Columns past the right border of level 0 that may be read: lets rows be correlated in blocks. */
inline constexpr int kReadablePadding_px = 32;

/** \param sigma_px  of the smoothing, 0 = none */
[[nodiscard]] MONOSLAM_VISION_EXPORT std::shared_ptr<const PreparedImage> prepareImage(
    const cv::Mat& grey, double sigma_px);

/** The pyramid alone: what a landmark keeps of the frame in which it was born. */
[[nodiscard]] MONOSLAM_VISION_EXPORT std::shared_ptr<const PreparedImage> withoutIntegrals(
    const PreparedImage& image);
}  // namespace monoslam
