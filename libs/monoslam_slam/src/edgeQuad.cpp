// SPDX-License-Identifier: BSD-3-Clause
#include "edgeQuad.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

namespace monoslam
{
namespace
{
constexpr double kLeastContrast = 15.0 / 255.0;
constexpr double kLeastSide_px = 12.0;
constexpr int kPasses = 3;
constexpr std::size_t kMany = 600;   ///< pixels along a side: a fifth do for a rough fit
constexpr double kRough = 5e-3;      ///< [px] and grey levels / 255
constexpr double kConverged = 2e-4;  ///< the same

/** A line x . n = c in undistorted normalised coordinates, between two corners. */
struct Side
{
    Eigen::Vector2d from;
    Eigen::Vector2d to;
    Eigen::Vector2d n;  ///< unit, points out of the quadrilateral
    double unit;        ///< normalised units of one pixel across the side, at its middle
    double length_px;
};

std::optional<Eigen::Vector2d> undistorted(const Camera& camera, const Eigen::Vector2d& uv_px,
                                           Eigen::Matrix2d* J = nullptr)
{
    const auto ray = camera.unproject(uv_px, J);
    return ray ? std::optional<Eigen::Vector2d>(ray->head<2>()) : std::nullopt;
}

std::optional<std::array<Side, 4>> sidesOf(const Camera& camera, const Quad& corners_px)
{
    Quad x;
    for (int k = 0; k < 4; ++k)
    {
        const auto x_n = undistorted(camera, corners_px[k]);
        if (!x_n) return std::nullopt;
        x[k] = *x_n;
    }
    const Eigen::Vector2d centre = (x[0] + x[1] + x[2] + x[3]) / 4.0;
    std::array<Side, 4> sides;
    for (int k = 0; k < 4; ++k)
    {
        Side& side = sides[k];
        side.from = x[k];
        side.to = x[(k + 1) % 4];
        side.n = (side.to - side.from).unitOrthogonal();
        if (side.n.dot(side.from - centre) < 0) side.n = -side.n;
        side.length_px = (corners_px[(k + 1) % 4] - corners_px[k]).norm();
        const Eigen::Vector2d middle = 0.5 * (side.from + side.to);
        const auto uv_px = camera.project(middle.homogeneous());
        Eigen::Matrix2d J;
        if (!uv_px || !undistorted(camera, *uv_px, &J)) return std::nullopt;
        side.unit = (J.transpose() * side.n).norm();
        if (side.length_px < kLeastSide_px) return std::nullopt;
    }
    return sides;
}

/** Pixels that may lie within reach of the side: a thick curve through its projection. */
std::vector<cv::Point> pixelsAlong(const Side& side, const Camera& camera, cv::Size size,
                                   double reach_px)
{
    std::vector<cv::Point> curve;
    for (int i = 0; i <= 16; ++i)
    {
        const Eigen::Vector2d x = side.from + (side.to - side.from) * (i / 16.0);
        const auto uv_px = camera.project(x.homogeneous());
        if (uv_px) curve.emplace_back(cvRound(uv_px->x()), cvRound(uv_px->y()));
    }
    if (curve.empty()) return {};
    const int width_px = 2 * static_cast<int>(std::ceil(reach_px)) + 3;
    const cv::Rect tight = cv::boundingRect(curve);
    const cv::Rect box = cv::Rect(tight.tl() - cv::Point(width_px, width_px),
                                  tight.size() + cv::Size(2 * width_px, 2 * width_px)) &
                         cv::Rect({}, size);
    if (box.empty()) return {};
    for (cv::Point& place : curve) place -= box.tl();
    cv::Mat mask = cv::Mat::zeros(box.size(), CV_8UC1);
    cv::polylines(mask, curve, false, 255, width_px);
    std::vector<cv::Point> places;
    cv::findNonZero(mask, places);
    for (cv::Point& place : places) place += box.tl();
    return places;
}

/** Says yes of one pixel in five. Scattered, for the pixels of a regular pattern may all be at the
 *  same few distances from a side. */
bool sampled(const cv::Point& place)
{
    std::uint32_t bits = 0x9E3779B1u * static_cast<std::uint32_t>(place.x) ^
                         0x85EBCA77u * static_cast<std::uint32_t>(place.y);
    bits = 0xC2B2AE3Du * (bits ^ bits >> 15);
    bits = 0x27D4EB2Fu * (bits ^ bits >> 13);
    return (bits ^ bits >> 16) % 5u == 0u;
}

/** \param all  else a sample of them, if they are many */
std::vector<EdgePixel> pixelsOf(const cv::Mat& image, const Camera& camera, const Side& side,
                                double reach_px, bool all)
{
    const Eigen::Vector2d along = (side.to - side.from).normalized();
    const double halfLength = 0.5 * (side.to - side.from).norm();
    const double margin_px = std::min(reach_px + 1.0, 0.2 * side.length_px);
    const double s_max = 1.0 - 2.0 * margin_px / side.length_px;
    const auto places = pixelsAlong(side, camera, image.size(), reach_px);
    all = all || places.size() < kMany;
    std::vector<EdgePixel> pixels;
    for (const auto& place : places)
    {
        if (!all && !sampled(place)) continue;
        Eigen::Matrix2d J;
        const auto x = undistorted(camera, {place.x, place.y}, &J);
        if (!x) continue;
        const double perPixel = (J.transpose() * side.n).norm();
        const Eigen::Vector2d from = *x - 0.5 * (side.from + side.to);
        const double s = from.dot(along) / halfLength;
        const double d_px = from.dot(side.n) / perPixel;
        if (std::abs(d_px) > reach_px || std::abs(s) > s_max) continue;
        pixels.push_back(
            {d_px, s, side.unit / perPixel, static_cast<double>(image.at<unsigned char>(place))});
    }
    return pixels;
}

std::array<std::vector<EdgePixel>, 4> pixelsOf(const cv::Mat& image, const Camera& camera,
                                               const std::array<Side, 4>& sides, double reach_px,
                                               bool all)
{
    std::array<std::vector<EdgePixel>, 4> pixels;
    for (std::size_t k = 0; k < 4; ++k)
        pixels[k] = pixelsOf(image, camera, sides[k], reach_px, all);
    return pixels;
}

/** Ends of the side's fitted line. */
std::pair<Eigen::Vector2d, Eigen::Vector2d> fittedLine(const Side& side, const SideFit& fit)
{
    return {side.from + side.unit * (fit.offset_px - fit.tilt_px) * side.n,
            side.to + side.unit * (fit.offset_px + fit.tilt_px) * side.n};
}

std::optional<Quad> cornersOf(const std::array<Side, 4>& sides, const EdgeFit& fit,
                              const Camera& camera)
{
    Quad corners_px;
    for (int k = 0; k < 4; ++k)
    {
        const auto a = fittedLine(sides[(k + 3) % 4], fit.sides[(k + 3) % 4]);
        const auto b = fittedLine(sides[k], fit.sides[k]);
        const Eigen::Vector3d la = a.first.homogeneous().cross(a.second.homogeneous());
        const Eigen::Vector3d lb = b.first.homogeneous().cross(b.second.homogeneous());
        const Eigen::Vector3d meet = la.cross(lb);
        if (!(std::abs(meet.z()) > 1e-12)) return std::nullopt;
        const auto uv_px = camera.project(meet / meet.z());
        if (!uv_px) return std::nullopt;
        corners_px[k] = *uv_px;
    }
    return corners_px;
}

bool straightEdges(const EdgeFit& fit, double reach_px)
{
    for (const auto& side : fit.sides)
    {
        const double contrast = std::abs(side.outside - side.inside);
        const double shift_px = std::abs(side.offset_px) + std::abs(side.tilt_px);
        if (contrast < kLeastContrast || contrast < 3.0 * fit.noise_grey / 255.0) return false;
        if (shift_px > reach_px || side.blur_px > 3.9) return false;
    }
    return true;
}
}  // namespace

std::optional<EdgeQuad> refineEdgeQuad(const cv::Mat& image, const Camera& camera,
                                       const Quad& rough_px)
{
    EdgeQuad result{rough_px, {}};
    std::optional<EdgeFit> fit;
    double reach_px = 5.0;
    for (int pass = 0; pass < kPasses; ++pass)
    {
        const auto sides = sidesOf(camera, result.corners_px);
        if (!sides) return std::nullopt;
        // The pixels are chosen anew after each pass but the last: until then a rough fit will do.
        const bool last = pass == kPasses - 1;
        const EdgeFit* before = fit ? &*fit : nullptr;
        std::optional<EdgeFit> next;
        if (!last)
            next = fitEdges(pixelsOf(image, camera, *sides, reach_px, false), before, kRough);
        if (!next)  // or the sample was too small
            next = fitEdges(pixelsOf(image, camera, *sides, reach_px, true), before,
                            last ? kConverged : kRough);
        if (!next || !straightEdges(*next, reach_px)) return std::nullopt;
        fit = next;
        const auto corners_px = cornersOf(*sides, *fit, camera);
        if (!corners_px) return std::nullopt;
        result = {*corners_px, *fit};
        double blur_px = 0.0;
        for (const auto& side : fit->sides) blur_px = std::max(blur_px, side.blur_px);
        reach_px = std::clamp(3.0 * blur_px + 1.5, 3.5, 8.0);
    }
    return result;
}
}  // namespace monoslam
