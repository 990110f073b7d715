// SPDX-License-Identifier: BSD-3-Clause
#include "rectangleEvidence.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace monoslam
{
namespace
{
constexpr double kLeastFilled = 0.9;  ///< share of the enclosed pixels that are dark
constexpr int kEdge_px = 2;           ///< from a side on, a pixel is wholly inside
constexpr double kDark = 0.5;         ///< of the surroundings' grey: a darker rectangle is dark
constexpr double kRoughlyDark = 0.6;  ///< the same before the sides are known
constexpr int kRough_px = 3;          ///< how far off rough corners are

bool darkInside(const EdgeFit& fit)
{
    return std::all_of(fit.sides.begin(), fit.sides.end(),
                       [](const SideFit& side) { return side.inside < kDark * side.outside; });
}

/** A quadrilateral's pixels in a part of the image that reaches \p margin_px beyond it. */
struct Region
{
    cv::Mat image;
    cv::Mat inside;  ///< 255 or 0
};

Region regionOf(const cv::Mat& image, const Quad& quad, int margin_px)
{
    std::vector<cv::Point> corners;
    for (const Eigen::Vector2d& corner : quad)
        corners.emplace_back(cvRound(corner.x()), cvRound(corner.y()));
    cv::Rect box = cv::boundingRect(corners);
    box -= cv::Point(margin_px, margin_px);
    box += cv::Size(2 * margin_px, 2 * margin_px);
    box &= cv::Rect({}, image.size());
    for (cv::Point& corner : corners) corner -= box.tl();
    Region region{image(box), cv::Mat::zeros(box.size(), CV_8UC1)};
    cv::fillConvexPoly(region.inside, corners, 255);
    return region;
}

cv::Mat shrunk(const cv::Mat& mask, int by_px)
{
    cv::Mat smaller;
    cv::erode(mask, smaller, cv::Mat::ones(2 * by_px + 1, 2 * by_px + 1, CV_8UC1), {-1, -1}, 1,
              cv::BORDER_CONSTANT, 0);
    return smaller;
}

cv::Mat grown(const cv::Mat& mask, int by_px)
{
    cv::Mat larger;
    cv::dilate(mask, larger, cv::Mat::ones(2 * by_px + 1, 2 * by_px + 1, CV_8UC1));
    return larger;
}

/** Whether what the sides enclose is dark as well: a frame round something else is no rectangle. */
bool filled(const cv::Mat& image, const EdgeQuad& edges)
{
    double middle = 0.0;
    for (const SideFit& side : edges.fit.sides)
        middle += 255.0 * (side.inside + side.outside) / 8.0;
    const Region region = regionOf(image, edges.corners_px, 0);
    const cv::Mat inside = shrunk(region.inside, kEdge_px);
    const cv::Mat dark = inside & (region.image < middle);
    return cv::countNonZero(dark) >= kLeastFilled * cv::countNonZero(inside);
}
}  // namespace

double perimeterOf(const Quad& quad)
{
    double length_px = 0.0;
    for (std::size_t k = 0; k < 4; ++k) length_px += (quad[(k + 1) % 4] - quad[k]).norm();
    return length_px;
}

bool roughlyDark(const cv::Mat& image, const Quad& quad)
{
    const Region region = regionOf(image, quad, 2 * kRough_px);
    const cv::Mat inside = shrunk(region.inside, kRough_px);
    const cv::Mat around = grown(region.inside, 2 * kRough_px) & ~grown(region.inside, kRough_px);
    return cv::countNonZero(inside) == 0 ||
           cv::mean(region.image, inside)[0] < kRoughlyDark * cv::mean(region.image, around)[0];
}

double evidenceOfRectangle(const cv::Mat& image, const EdgeQuad& edges)
{
    if (!darkInside(edges.fit) || !filled(image, edges)) return 0.0;
    double contrast = 1.0;
    for (const SideFit& side : edges.fit.sides)
        contrast = std::min(contrast, side.outside - side.inside);
    return contrast * contrast * perimeterOf(edges.corners_px);
}
}  // namespace monoslam
