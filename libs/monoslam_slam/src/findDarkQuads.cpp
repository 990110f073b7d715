// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "findTarget.h"

namespace monoslam
{
namespace
{
constexpr double kLeastSide_px = 15.0;
constexpr double kBorder_px = 3.0;
constexpr double kSameQuad_px = 3.0;
constexpr double kLeastFilled = 0.85;      ///< of the quadrilateral's area
constexpr double kHopelesslyHollow = 0.6;  ///< of the hull's: spares most contours the lens

/** Dark regions (255) at several levels: globally and against the neighbourhood. */
std::vector<cv::Mat> darkRegions(const cv::Mat& image)
{
    cv::Mat smooth;
    cv::GaussianBlur(image, smooth, {3, 3}, 0.8);
    cv::Mat mask;
    const double otsu =
        cv::threshold(smooth, mask, 0, 255, cv::THRESH_BINARY_INV | cv::THRESH_OTSU);
    std::vector<cv::Mat> masks{mask};
    for (const double share : {0.5, 0.75, 1.25})
    {
        cv::Mat level;
        cv::threshold(smooth, level, share * otsu, 255, cv::THRESH_BINARY_INV);
        masks.push_back(level);
    }
    for (const int block : {image.cols / 24 * 2 + 1, image.cols / 6 * 2 + 1})
    {
        cv::Mat local;
        cv::adaptiveThreshold(smooth, local, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV,
                              std::max(block, 11), 10);
        masks.push_back(local);
    }
    return masks;
}

/** The contour as four corners, judged without the lens's bending of its sides. */
std::optional<Quad> quadOf(const std::vector<cv::Point>& contour, const Camera& camera)
{
    std::vector<cv::Point> bentHull;
    cv::convexHull(contour, bentHull);
    const double filled = cv::contourArea(contour) / cv::contourArea(bentHull);
    if (filled < kHopelesslyHollow) return std::nullopt;
    const float f_px = static_cast<float>(camera.parameters().fx_px);
    std::vector<cv::Point2f> straight;
    for (const auto& p : bentHull)
    {
        const auto ray = camera.unproject({p.x, p.y});
        if (!ray) return std::nullopt;
        straight.emplace_back(f_px * static_cast<float>(ray->x()),
                              f_px * static_cast<float>(ray->y()));
    }
    std::vector<cv::Point2f> hull;
    std::vector<cv::Point2f> corners;
    cv::convexHull(straight, hull);
    cv::approxPolyDP(hull, corners, 0.03 * cv::arcLength(hull, true), true);
    if (corners.size() != 4 || !cv::isContourConvex(corners)) return std::nullopt;
    if (filled * cv::contourArea(hull) < kLeastFilled * cv::contourArea(corners))
        return std::nullopt;
    Quad quad;
    for (int k = 0; k < 4; ++k)
    {
        const Eigen::Vector3d ray(corners[k].x / f_px, corners[k].y / f_px, 1.0);
        const auto uv_px = camera.project(ray);
        if (!uv_px || !camera.contains(*uv_px, kBorder_px)) return std::nullopt;
        quad[k] = *uv_px;
    }
    return quad;
}

double shortestSide(const Quad& quad)
{
    double shortest_px = (quad[3] - quad[0]).norm();
    for (int k = 0; k < 3; ++k) shortest_px = std::min(shortest_px, (quad[k + 1] - quad[k]).norm());
    return shortest_px;
}

double signedArea(const Quad& quad)
{
    double sum = 0.0;
    for (int k = 0; k < 4; ++k)
    {
        const Eigen::Vector2d& a = quad[k];
        const Eigen::Vector2d& b = quad[(k + 1) % 4];
        sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return sum;
}

bool isAmong(const std::vector<Quad>& quads, const Quad& quad)
{
    const auto centre = [](const Quad& q) -> Eigen::Vector2d
    { return 0.25 * (q[0] + q[1] + q[2] + q[3]); };
    const auto same = [&](const Quad& other)
    {
        return (centre(other) - centre(quad)).norm() < kSameQuad_px &&
               std::abs(shortestSide(other) - shortestSide(quad)) < kSameQuad_px;
    };
    return std::any_of(quads.begin(), quads.end(), same);
}
}  // namespace

std::vector<Quad> findDarkQuads(const cv::Mat& image, const Camera& camera)
{
    std::vector<Quad> quads;
    for (const auto& mask : darkRegions(image))
    {
        std::vector<std::vector<cv::Point>> contours;
        cv::findContours(mask, contours, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
        for (const auto& contour : contours)
        {
            if (cv::contourArea(contour) < 0.5 * kLeastSide_px * kLeastSide_px) continue;
            auto quad = quadOf(contour, camera);
            if (!quad || shortestSide(*quad) < kLeastSide_px || isAmong(quads, *quad)) continue;
            if (signedArea(*quad) > 0) std::reverse(quad->begin(), quad->end());
            quads.push_back(*quad);
        }
    }
    std::sort(quads.begin(), quads.end(),
              [](const Quad& a, const Quad& b) { return signedArea(a) < signedArea(b); });
    return quads;
}
}  // namespace monoslam
