// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

#include "renderPlane.h"

/** A plane of squares of random light: wherever four of them meet is a corner whose place in the
 *  world is known. */
namespace monoslam
{
/** Random numbers in [0, 1) that depend on nothing but the square. */
inline double lightOfSquare(std::int64_t i, std::int64_t j, std::uint64_t seed)
{
    std::uint64_t h = seed * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(i);
    for (const auto more : {static_cast<std::uint64_t>(j), seed})  // mixing of splitmix64
    {
        h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ULL;
        h = (h ^ (h >> 27)) * 0x94d049bb133111ebULL + more;
    }
    h ^= h >> 31;
    return static_cast<double>(h >> 11) * 0x1p-53;
}

/** The plane z = 0 with squares of side_m; black and white in turn, so that no corner is weak. */
inline PaintedPlane mosaic(double side_m, std::uint64_t seed = 1)
{
    PaintedPlane plane;
    plane.light = [side_m, seed](double x_m, double y_m)
    {
        const auto i = static_cast<std::int64_t>(std::floor(x_m / side_m));
        const auto j = static_cast<std::int64_t>(std::floor(y_m / side_m));
        const double light = 0.35 * lightOfSquare(i, j, seed);
        return (i + j) % 2 == 0 ? light : 0.5 + light;
    };
    return plane;
}

/** A pinhole of 240 x 180, cheap to render for. */
inline Camera smallCamera()
{
    CameraParameters p;
    p.width_px = 240;
    p.height_px = 180;
    p.fx_px = p.fy_px = 170.0;
    p.cx_px = 119.5;
    p.cy_px = 89.5;
    return Camera(p);
}

/** The corners of a mosaic that a camera sees at least border_px inside its image. */
inline std::vector<Eigen::Vector3d> mosaicCorners(double side_m, const Camera& camera,
                                                  const Eigen::Matrix<double, 7, 1>& pose,
                                                  double border_px)
{
    constexpr int kReach = 30;
    std::vector<Eigen::Vector3d> corners;
    for (int i = -kReach; i <= kReach; ++i)
        for (int j = -kReach; j <= kReach; ++j)
        {
            const Eigen::Vector3d p_w(i * side_m, j * side_m, 0.0);
            const Eigen::Vector3d p_c = rotateInverse(pose.tail<4>(), p_w - pose.head<3>());
            const auto uv = camera.project(p_c);
            if (uv && camera.contains(*uv, border_px)) corners.push_back(p_w);
        }
    return corners;
}
}  // namespace monoslam
