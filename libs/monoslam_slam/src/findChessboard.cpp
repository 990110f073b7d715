// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "findTarget.h"

namespace monoslam
{
namespace
{
double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/** Corners (0, 0), (n-1, 0), (n-1, m-1), (0, m-1); x cross y points into the scene. */
Quad outerCorners(const std::vector<cv::Point2f>& grid, const Eigen::Vector2i& counts)
{
    const auto at = [&](int i, int j)
    {
        const cv::Point2f& p = grid[static_cast<std::size_t>(j * counts.x() + i)];
        return Eigen::Vector2d(p.x, p.y);
    };
    const int n = counts.x() - 1;
    const int m = counts.y() - 1;
    Quad quad{at(0, 0), at(n, 0), at(n, m), at(0, m)};
    if (cross(quad[1] - quad[0], quad[3] - quad[0]) < 0)
        quad = {at(0, m), at(n, m), at(n, 0), at(0, 0)};
    return quad;
}

/** OpenCV's board finder is up to half a pixel off on slanted boards: refines within a third of a
 *  square. */
Quad refinedCorners(const cv::Mat& image, Quad quad, const std::vector<cv::Point2f>& grid)
{
    double spacing_px = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < grid.size(); ++i)
        spacing_px = std::min(spacing_px, cv::norm(grid[i] - grid[i - 1]));
    const int window_px = std::clamp(static_cast<int>(spacing_px / 3.0), 3, 8);
    for (auto& corner_px : quad)
        corner_px = refineCorner(image, corner_px, window_px).value_or(corner_px);
    return quad;
}

/** Of the labellings that the board's outline allows, the one whose x axis points most to the
 *  right in the image: half turns, and for equal counts quarter turns. */
Quad uprightLabelling(const Quad& quad, bool square)
{
    Quad best = quad;
    for (int turn = square ? 1 : 2; turn < 4; turn += square ? 1 : 2)
    {
        Quad turned;
        for (int k = 0; k < 4; ++k) turned[k] = quad[(k + turn) % 4];
        const double x = (turned[1] - turned[0]).normalized().x();
        if (x > (best[1] - best[0]).normalized().x()) best = turned;
    }
    return best;
}
/** The board's corners by the half-size image, which takes a quarter of the time, else by the whole
 *  one; row by row, to a fraction of a square. */
std::vector<cv::Point2f> findGrid(const cv::Mat& image, const cv::Size& size)
{
    std::vector<cv::Point2f> grid;
    cv::Mat half;
    cv::pyrDown(image, half);
    if (cv::findChessboardCornersSB(half, size, grid, cv::CALIB_CB_NORMALIZE_IMAGE))
    {
        for (cv::Point2f& corner : grid) corner *= 2.0F;
        return grid;
    }
    grid.clear();
    if (!cv::findChessboardCornersSB(image, size, grid, cv::CALIB_CB_NORMALIZE_IMAGE)) return {};
    return grid;
}
}  // namespace

TargetSearch findChessboard(const cv::Mat& image, const MetricStartOptions& options)
{
    const Eigen::Vector2i& counts = options.chessboard_inner_corners;
    const std::vector<cv::Point2f> grid = findGrid(image, {counts.x(), counts.y()});
    if (grid.empty()) return {std::nullopt, "no chessboard of that size in the image"};
    const Quad quad = refinedCorners(
        image, uprightLabelling(outerCorners(grid, counts), counts.x() == counts.y()), grid);
    const double x_m = options.chessboard_square_m * (counts.x() - 1);
    const double y_m = options.chessboard_square_m * (counts.y() - 1);
    SeenPoints seen;
    seen.points_m = {{0, 0, 0}, {x_m, 0, 0}, {x_m, y_m, 0}, {0, y_m, 0}};
    seen.pixels_px.assign(quad.begin(), quad.end());
    seen.sigmas_px.assign(4, options.corner_sigma_px);
    seen.point_sigma_m = options.point_sigma_m;
    return {seen, {}};
}
}  // namespace monoslam
