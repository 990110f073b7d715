// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "monoslam_mrpt/timestamps.h"

namespace monoslam
{
/** One image of a sequence: a file, or pixels out of a video. */
struct SourceImage
{
    Ticks t = 0;
    std::string file;
    cv::Mat pixels;
};

/** Images one after another, nothing at the end. */
using ImageSource = std::function<std::optional<SourceImage>()>;

struct SourceOptions
{
    std::string format;  ///< tum, euroc, kitti, folder, video
    std::string input;
    double fps_hz = 0.0;  ///< 0 = not given
};

[[nodiscard]] const std::vector<std::string>& sourceFormats();

/** \throw std::runtime_error naming file and line */
[[nodiscard]] ImageSource openSource(const SourceOptions& options);
}  // namespace monoslam
