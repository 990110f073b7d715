// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "monoslam_vision/detectCorners.h"
#include "mosaic.h"
#include "texture.h"

/** A plane without edges or repetition, for what has to be told apart by its looks. */
namespace monoslam
{
/** The plane z = 0 with waves of 10 to 50 mm on it, within a metre of the origin. */
inline PaintedPlane wavyPlane(unsigned seed)
{
    constexpr double kStep_m = 0.002;
    constexpr int kSide = 1001;
    const Texture texture(seed, 40.0);
    auto table = std::make_shared<std::vector<double>>();  // the sum of waves is slow
    for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i) table->push_back(texture.at(1.2 * i, 1.2 * j) / 255.0);
    PaintedPlane plane;
    plane.light = [table](double x_m, double y_m)
    {
        const double x = std::clamp(x_m / kStep_m + 0.5 * kSide, 0.0, kSide - 1.001);
        const double y = std::clamp(y_m / kStep_m + 0.5 * kSide, 0.0, kSide - 1.001);
        const auto i = static_cast<std::size_t>(x);
        const auto j = static_cast<std::size_t>(y);
        const double a = x - static_cast<double>(i);
        const double b = y - static_cast<double>(j);
        const double* at = table->data() + j * kSide + i;
        return (1 - b) * ((1 - a) * at[0] + a * at[1]) +
               b * ((1 - a) * at[kSide] + a * at[kSide + 1]);
    };
    return plane;
}

/** What the small camera sees of that plane; rendered once. */
inline std::shared_ptr<const PreparedImage> wavyView(const Eigen::Matrix<double, 7, 1>& pose,
                                                     unsigned seed = 1)
{
    static std::map<std::pair<unsigned, std::vector<double>>, std::shared_ptr<const PreparedImage>>
        rendered;
    auto& view = rendered[{seed, {pose.begin(), pose.end()}}];
    if (!view) view = prepareImage(renderPlane(wavyPlane(seed), smallCamera(), pose, {}), 0.7);
    return view;
}

/** Some 60 pixels of corners, spread over the image. */
inline std::vector<Eigen::Vector2d> cornersOf(const PreparedImage& image)
{
    double strongest = 0.0;
    std::mt19937 rng(1);
    DetectionOptions options;
    options.minDistance_px = 10.0;
    options.maxCells = 1 << 20;
    std::vector<Eigen::Vector2d> pixels;
    for (const Corner& corner : detectCorners(image, {}, 60, options, strongest, rng))
        pixels.push_back(corner.uv_px);
    return pixels;
}

/** Points of that plane where a camera sees corners; \p pixels are those of the corners. */
inline std::vector<Eigen::Vector3d> pointsOfPlane(const Camera& camera,
                                                  const Eigen::Matrix<double, 7, 1>& pose,
                                                  const std::vector<Eigen::Vector2d>& pixels)
{
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector2d& uv_px : pixels)
    {
        const Eigen::Vector3d ray = rotationMatrix(pose.tail<4>()) * *camera.unproject(uv_px);
        points.emplace_back(pose.head<3>() - ray * pose(2) / ray.z());
    }
    return points;
}
}  // namespace monoslam
