// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <array>

#include "monoslam_slam/MetricStart.h"
#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
namespace
{
/** Consecutive numbers as points; the count has to be exact. */
template <int Size>
std::vector<Eigen::Matrix<double, Size, 1>> readPoints(ConfigSection& section,
                                                       const std::string& key, std::size_t count)
{
    const auto numbers = section.get(key, std::vector<double>{});
    if (numbers.size() != count * Size)
        section.fail(key, "needs " + std::to_string(count * Size) + " numbers, has " +
                              std::to_string(numbers.size()));
    std::vector<Eigen::Matrix<double, Size, 1>> points(count);
    for (std::size_t i = 0; i < count; ++i)
        points[i] = Eigen::Map<const Eigen::Matrix<double, Size, 1>>(&numbers[i * Size]);
    return points;
}

constexpr std::array<std::array<int, 3>, 4> kTriples{{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
constexpr double kLeastSine = 0.05;        ///< of the angles of any three points
constexpr double kLargestOffPlane = 0.01;  ///< relative to the target's size

/** Smallest sine of an angle between the sides of the triangle. */
double flatness(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
    const double area2 = (b - a).cross(c - a).norm();
    std::array<double, 3> sides{(b - a).norm(), (c - b).norm(), (a - c).norm()};
    std::sort(sides.begin(), sides.end());
    return sides[0] > 0 ? area2 / (sides[1] * sides[2]) : 0.0;
}

void checkTargetPoints(const MetricStartOptions& o, const ConfigSection& section)
{
    const auto& points = o.target_points_m;
    const auto& pixels = o.target_points_px;
    for (const auto& t : kTriples)
    {
        if (flatness(points[t[0]], points[t[1]], points[t[2]]) < kLeastSine)
            section.fail("target_points_m", "three of the points lie on one line");
        if (flatness(pixels[t[0]].homogeneous(), pixels[t[1]].homogeneous(),
                     pixels[t[2]].homogeneous()) < 0.5 * kLeastSine)
            section.fail("target_points_px", "three of the pixels lie on one line");
    }
    Eigen::Matrix<double, 3, 4> spread;
    for (int i = 0; i < 4; ++i) spread.col(i) = points[static_cast<std::size_t>(i)];
    spread.colwise() -= spread.rowwise().mean().eval();
    const Eigen::Vector3d size =
        Eigen::JacobiSVD<Eigen::Matrix<double, 3, 4>>(spread).singularValues();
    if (size(2) > kLargestOffPlane * size(0))
        section.fail("target_points_m", "the four points do not lie on one plane");
}

Eigen::Vector2d readPair(ConfigSection& section, const std::string& key,
                         const Eigen::Vector2d& fallback)
{
    const auto numbers = section.get(key, std::vector<double>{fallback.x(), fallback.y()});
    if (numbers.size() != 2) section.fail(key, "needs two numbers");
    return {numbers[0], numbers[1]};
}
}  // namespace

MetricStartOptions MetricStartOptions::from(ConfigSection section)
{
    MetricStartOptions o;
    o.method = section.get("method", o.method,
                           {{"none", MetricStartMethod::None},
                            {"target_points", MetricStartMethod::TargetPoints},
                            {"rectangle", MetricStartMethod::Rectangle},
                            {"chessboard", MetricStartMethod::Chessboard}});
    const bool needsPoints = o.method == MetricStartMethod::TargetPoints;
    if (needsPoints || section.has("target_points_m") || section.has("target_points_px"))
    {
        o.target_points_m = readPoints<3>(section, "target_points_m", 4);
        o.target_points_px = readPoints<2>(section, "target_points_px", 4);
        checkTargetPoints(o, section);
    }
    o.rectangle_size_m = readPair(section, "rectangle_size_m", o.rectangle_size_m);
    if (!(o.rectangle_size_m.minCoeff() > 0 && o.rectangle_size_m.allFinite()))
        section.fail("rectangle_size_m", "both sides must be > 0");
    const Eigen::Vector2d counts =
        readPair(section, "chessboard_inner_corners", o.chessboard_inner_corners.cast<double>());
    o.chessboard_inner_corners = counts.cast<int>();
    if (o.chessboard_inner_corners.cast<double>() != counts || !(counts.minCoeff() >= 3) ||
        !(counts.maxCoeff() <= 100))
        section.fail("chessboard_inner_corners", "needs two whole numbers from 3 to 100");
    o.chessboard_square_m = section.get("chessboard_square_m", o.chessboard_square_m, {1e-4, 100});
    o.corner_sigma_px = section.get("corner_sigma_px", o.corner_sigma_px, {1e-3, 10});
    o.point_sigma_m = section.get("point_sigma_m", o.point_sigma_m, {0, 1});
    section.rejectUnknownKeys();
    return o;
}
}  // namespace monoslam
