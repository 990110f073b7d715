// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/PreparedImage.h"

#include <opencv2/imgproc.hpp>

namespace monoslam
{
namespace
{
constexpr int kLevels = 3;
}  // namespace

std::shared_ptr<const PreparedImage> prepareImage(const cv::Mat& grey, double sigma_px)
{
    auto prepared = std::make_shared<PreparedImage>();
    prepared->width_px = grey.cols;
    prepared->height_px = grey.rows;

    cv::Mat padded(grey.rows, grey.cols + kReadablePadding_px, CV_8UC1);
    cv::Mat base = padded.colRange(0, grey.cols);
    padded.colRange(grey.cols, padded.cols).setTo(0);
    if (sigma_px > 0.0)
        cv::GaussianBlur(grey, base, cv::Size(5, 5), sigma_px, sigma_px,
                         cv::BORDER_REPLICATE | cv::BORDER_ISOLATED);
    else
        grey.copyTo(base);

    prepared->levels.push_back(base);
    for (int level = 1; level < kLevels; ++level)
    {
        cv::Mat half;
        cv::pyrDown(prepared->levels.back(), half);
        prepared->levels.push_back(half);
    }
    cv::integral(base, prepared->sum, prepared->squareSum, CV_32S, CV_64F);
    return prepared;
}

std::shared_ptr<const PreparedImage> withoutIntegrals(const PreparedImage& image)
{
    auto copy = std::make_shared<PreparedImage>(image);
    copy->sum.release();
    copy->squareSum.release();
    return copy;
}
}  // namespace monoslam
