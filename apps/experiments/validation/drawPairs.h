// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "monoslam_association/Associator.h"

namespace monoslam
{
struct JudgedPair
{
    Association pair;
    bool wrong = false;
};

/** The image with every pair: green accepted and right, magenta accepted and wrong, red rejected
 *  and wrong, yellow rejected and right; a line from the prediction to the match. */
[[nodiscard]] cv::Mat drawPairs(const cv::Mat& image, const std::vector<JudgedPair>& pairs,
                                const std::string& title);
}  // namespace monoslam
