// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "findTarget.h"

namespace monoslam
{
namespace
{
constexpr double kRoughSigma_px = 2.0;
constexpr int kLeastWindow_px = 3;
constexpr int kLargestWindow_px = 8;
constexpr double kLeastCornerSlope_grey = 4.0;

/** Half a window that holds one corner of the target only. At the border it may leave the image:
 *  OpenCV repeats the last pixel there, which has no gradient and so no say. */
int windowFor(const std::vector<Eigen::Vector2d>& pixels_px, std::size_t i)
{
    double nearest_px = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < pixels_px.size(); ++j)
        if (j != i) nearest_px = std::min(nearest_px, (pixels_px[j] - pixels_px[i]).norm());
    return std::clamp(static_cast<int>(0.15 * nearest_px), kLeastWindow_px, kLargestWindow_px);
}

/** Root of the smaller eigenvalue of the mean gradient tensor [grey levels / px]. */
double cornerSlope(const cv::Mat& image, const Eigen::Vector2d& at_px, int window_px)
{
    const cv::Rect all(0, 0, image.cols, image.rows);
    const cv::Point c(cvRound(at_px.x()), cvRound(at_px.y()));
    const cv::Rect box =
        cv::Rect(c.x - window_px - 1, c.y - window_px - 1, 2 * window_px + 3, 2 * window_px + 3) &
        all;
    if (box.width < 5 || box.height < 5) return 0.0;
    cv::Mat smooth;
    cv::Mat gx;
    cv::Mat gy;
    cv::GaussianBlur(image(box), smooth, {3, 3}, 0.8);
    cv::Sobel(smooth, gx, CV_64F, 1, 0, 3, 1.0 / 8.0);
    cv::Sobel(smooth, gy, CV_64F, 0, 1, 3, 1.0 / 8.0);
    const double n = static_cast<double>(box.area());
    const double a = gx.dot(gx) / n;
    const double b = gx.dot(gy) / n;
    const double d = gy.dot(gy) / n;
    return std::sqrt(std::max(0.0, 0.5 * (a + d) - std::hypot(0.5 * (a - d), b)));
}

/** Order around the convex hull; nothing if one point lies inside the triangle of the others. */
std::optional<std::array<std::size_t, 4>> aroundHull(const std::vector<Eigen::Vector2d>& pixels_px)
{
    std::vector<cv::Point2f> points;
    for (const auto& p : pixels_px)
        points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
    std::vector<int> hull;
    cv::convexHull(points, hull);
    if (hull.size() != 4) return std::nullopt;
    std::array<std::size_t, 4> order{};
    std::transform(hull.begin(), hull.end(), order.begin(),
                   [](int i) { return static_cast<std::size_t>(i); });
    return order;
}

/** Replaces corners by the meeting points of fitted sides, where there are such sides. */
bool refineBySides(const cv::Mat& image, const Camera& camera, SeenPoints& seen, double sigma_px)
{
    const auto order = aroundHull(seen.pixels_px);
    if (!order) return false;
    Quad rough_px;
    for (int k = 0; k < 4; ++k) rough_px[k] = seen.pixels_px[(*order)[k]];
    const auto quad = refineEdgeQuad(image, camera, rough_px);
    if (!quad) return false;
    for (int k = 0; k < 4; ++k)
    {
        const bool refined = seen.sigmas_px[(*order)[k]] < kRoughSigma_px;
        const double limit_px = refined ? 2.0 : kLargestWindow_px;
        if ((quad->corners_px[k] - rough_px[k]).norm() > limit_px) return false;
    }
    for (int k = 0; k < 4; ++k)
    {
        seen.pixels_px[(*order)[k]] = quad->corners_px[k];
        seen.sigmas_px[(*order)[k]] = sigma_px;
    }
    return true;
}
}  // namespace

std::optional<Eigen::Vector2d> refineCorner(const cv::Mat& image, const Eigen::Vector2d& rough_px,
                                            int window_px)
{
    const cv::TermCriteria stop(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 60, 1e-3);
    Eigen::Vector2d at_px = rough_px;
    for (const int window : {window_px, std::min(window_px, 5)})
    {
        std::vector<cv::Point2f> corner{
            {static_cast<float>(at_px.x()), static_cast<float>(at_px.y())}};
        cv::cornerSubPix(image, corner, {window, window}, {-1, -1}, stop);
        const Eigen::Vector2d next_px(corner[0].x, corner[0].y);
        // OpenCV hands the very same point back when it diverges
        const bool unmoved = next_px == at_px.cast<float>().cast<double>();
        if (unmoved && window == window_px && at_px == rough_px) return std::nullopt;
        at_px = next_px;
    }
    const double moved_px = (at_px - rough_px).cwiseAbs().maxCoeff();
    if (moved_px > window_px) return std::nullopt;
    if (cornerSlope(image, at_px, std::min(window_px, 5)) < kLeastCornerSlope_grey)
        return std::nullopt;
    return at_px;
}

TargetSearch refineTargetPoints(const cv::Mat& image, const Camera& camera,
                                const MetricStartOptions& options)
{
    SeenPoints seen{options.target_points_m, options.target_points_px, {}, options.point_sigma_m};
    std::ostringstream note;
    for (std::size_t i = 0; i < seen.pixels_px.size(); ++i)
    {
        if (!camera.contains(seen.pixels_px[i]))
        {
            note << "target point " << i + 1 << " lies outside the image";
            return {std::nullopt, note.str()};
        }
        const int window_px = windowFor(options.target_points_px, i);
        const auto corner_px = refineCorner(image, seen.pixels_px[i], window_px);
        if (corner_px) seen.pixels_px[i] = *corner_px;
        seen.sigmas_px.push_back(corner_px ? options.corner_sigma_px
                                           : std::max(kRoughSigma_px, options.corner_sigma_px));
    }
    if (refineBySides(image, camera, seen, options.corner_sigma_px)) return {seen, {}};
    for (std::size_t i = 0; i < seen.sigmas_px.size(); ++i)
        if (seen.sigmas_px[i] > options.corner_sigma_px)
            note << "no corner at target point " << i + 1 << ", its rough pixel is used; ";
    return {seen, note.str()};
}
}  // namespace monoslam
