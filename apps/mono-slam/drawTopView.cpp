// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "drawPictures.h"
#include "monoslam_slam/writers.h"

namespace monoslam
{
namespace
{
using Points = std::vector<Eigen::Vector3d>;

const cv::Scalar kPath(200, 80, 20), kLandmark(60, 150, 40), kKnown(40, 40, 220);
constexpr int kSize_px = 900;
constexpr double kMargin_px = 60.0;

/** Positions in the plane, with a common scale. */
struct Projection
{
    Eigen::Matrix<double, 2, 3> axes;
    Eigen::Vector2d lowest;
    double scale = 1.0;  ///< [px per unit]

    [[nodiscard]] cv::Point2d operator()(const Eigen::Vector3d& p) const
    {
        const Eigen::Vector2d q = (axes * p - lowest) * scale;
        return {kMargin_px + q.x(), kSize_px - kMargin_px - q.y()};
    }
};

/** Without the farthest tenth, which would make all else small. */
Points withoutOutliers(Points points, const Eigen::Vector3d& centre)
{
    std::sort(points.begin(), points.end(),
              [&](const auto& a, const auto& b)
              { return (a - centre).squaredNorm() < (b - centre).squaredNorm(); });
    points.resize(points.size() - points.size() / 10);
    return points;
}

Projection projectionOf(const Points& points)
{
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const auto& p : points) mean += p / static_cast<double>(points.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const auto& p : points) scatter += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    Projection projection;
    projection.axes.row(0) = solver.eigenvectors().col(2).transpose();
    projection.axes.row(1) = solver.eigenvectors().col(1).transpose();
    Eigen::Vector2d highest = Eigen::Vector2d::Constant(-1e30);
    projection.lowest = -highest;
    for (const auto& p : points)
    {
        projection.lowest = projection.lowest.cwiseMin(projection.axes * p);
        highest = highest.cwiseMax(projection.axes * p);
    }
    const double extent = std::max((highest - projection.lowest).maxCoeff(), 1e-9);
    projection.scale = (kSize_px - 2 * kMargin_px) / extent;
    return projection;
}

void drawScaleBar(cv::Mat& picture, double scale)
{
    const double length = std::pow(10.0, std::floor(std::log10(0.4 * kSize_px / scale)));
    const cv::Point2d start(kMargin_px, kSize_px - 20);
    cv::line(picture, start, start + cv::Point2d(length * scale, 0), cv::Scalar::all(0), 2);
    char text[40];
    std::snprintf(text, sizeof text, "%g", length);
    cv::putText(picture, text, start + cv::Point2d(0, -6), cv::FONT_HERSHEY_SIMPLEX, 0.5,
                cv::Scalar::all(0), 1, cv::LINE_AA);
}
}  // namespace

cv::Mat drawTopView(const std::vector<Vector7d>& path, const std::vector<MapLandmark>& map)
{
    cv::Mat picture(kSize_px, kSize_px, CV_8UC3, cv::Scalar::all(255));
    Points positions, landmarks;
    for (const auto& pose : path) positions.emplace_back(pose.head<3>());
    for (const auto& landmark : map)
        if (const auto point = pointOf(landmark)) landmarks.push_back(point->p);
    if (positions.empty()) return picture;
    Points shown = withoutOutliers(landmarks, positions.back());
    shown.insert(shown.end(), positions.begin(), positions.end());
    const Projection toPicture = projectionOf(shown);
    for (const auto& landmark : map)
        if (const auto point = pointOf(landmark))
            cv::circle(picture, toPicture(point->p), 3, landmark.known ? kKnown : kLandmark,
                       cv::FILLED, cv::LINE_AA);
    for (std::size_t i = 1; i < positions.size(); ++i)
        cv::line(picture, toPicture(positions[i - 1]), toPicture(positions[i]), kPath, 2,
                 cv::LINE_AA);
    cv::drawMarker(picture, toPicture(positions.front()), kPath, cv::MARKER_DIAMOND, 14, 2);
    cv::drawMarker(picture, toPicture(positions.back()), kPath, cv::MARKER_TILTED_CROSS, 14, 2);
    drawScaleBar(picture, toPicture.scale);
    return picture;
}
}  // namespace monoslam
