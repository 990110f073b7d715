// SPDX-License-Identifier: BSD-3-Clause
#include "drawPairs.h"

#include <opencv2/imgproc.hpp>

namespace monoslam
{
namespace
{
const cv::Scalar kGreen(60, 200, 60), kMagenta(255, 0, 255), kRed(30, 30, 255),
    kYellow(0, 220, 255);

cv::Point2d toPoint(const Eigen::Vector2d& p)
{
    return {p.x(), p.y()};
}

cv::Scalar colourOf(const JudgedPair& judged)
{
    if (judged.pair.fate == Fate::Rejected) return judged.wrong ? kRed : kYellow;
    return judged.wrong ? kMagenta : kGreen;
}
}  // namespace

cv::Mat drawPairs(const cv::Mat& image, const std::vector<JudgedPair>& pairs,
                  const std::string& title)
{
    cv::Mat picture;
    cv::cvtColor(image, picture, cv::COLOR_GRAY2BGR);
    for (const JudgedPair& judged : pairs)
    {
        const cv::Scalar colour = colourOf(judged);
        const cv::Point at = toPoint(judged.pair.z);
        cv::line(picture, toPoint(judged.pair.h), at, colour, 1, cv::LINE_AA);
        if (judged.pair.fate == Fate::Rejected)
            cv::drawMarker(picture, at, colour, cv::MARKER_TILTED_CROSS, 13, 2, cv::LINE_AA);
        else
            cv::circle(picture, at, 5, colour, 1, cv::LINE_AA);
    }
    cv::rectangle(picture, {0, 0}, {picture.cols, 18}, cv::Scalar::all(0), cv::FILLED);
    cv::putText(picture, title, {4, 13}, cv::FONT_HERSHEY_SIMPLEX, 0.42, cv::Scalar::all(255), 1,
                cv::LINE_AA);
    return picture;
}
}  // namespace monoslam
