// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "monoslam_models/Camera.h"
#include "monoslam_slam/FrameReport.h"

namespace monoslam
{
/** The frame with what became of every landmark: 99 % ellipses of the search, matches green,
 *  rejections red, not found yellow, new landmarks blue. */
[[nodiscard]] cv::Mat drawFrame(const cv::Mat& image, const FrameReport& report,
                                const std::vector<MapLandmark>& added, const Camera& camera);

/** Path and map in the plane in which they extend most, with a scale bar. */
[[nodiscard]] cv::Mat drawTopView(const std::vector<Vector7d>& path,
                                  const std::vector<MapLandmark>& map);

/** \throw std::runtime_error naming the file */
void savePicture(const std::string& file, const cv::Mat& picture);
}  // namespace monoslam
