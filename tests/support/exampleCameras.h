// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "monoslam_models/Camera.h"
#include "randomValues.h"

namespace monoslam
{
inline constexpr double kDegree = 3.14159265358979323846 / 180.0;

inline CameraParameters cameraParameters(DistortionModel model, std::array<double, 8> k)
{
    CameraParameters p;
    p.width_px = 640;
    p.height_px = 480;
    p.fx_px = 420.0;
    p.fy_px = 415.0;
    p.cx_px = 318.0;
    p.cy_px = 242.0;
    p.distortion = {model, k};
    return p;
}

inline CameraParameters sceneLibParameters()
{
    CameraParameters p;
    p.width_px = 320;
    p.height_px = 240;
    p.fx_px = p.fy_px = 195.0;
    p.cx_px = 162.0;
    p.cy_px = 125.0;
    p.distortion = {DistortionModel::Davison, {9e-6}};
    return p;
}

/** One or more of each model, both signs of the first coefficient. */
inline std::vector<CameraParameters> exampleCameras()
{
    using D = DistortionModel;
    return {cameraParameters(D::None, {}),
            cameraParameters(D::Brown, {-0.28, 0.07, 1e-3, -5e-4, -0.008}),
            cameraParameters(D::Brown, {0.12, -0.2, -7e-4, 2e-3, 0.06}),
            cameraParameters(D::Brown, {0.6, 0.15, 2e-4, -1e-4, 0.01, 0.9, 0.35, 0.04}),
            cameraParameters(D::KannalaBrandt, {-0.02, 0.006, -0.004, 0.0008}),
            cameraParameters(D::KannalaBrandt, {0.05, -0.02, 0.01, -0.002}),
            cameraParameters(D::Tsai, {0.063, 0.0139, 0.0056}),
            cameraParameters(D::Tsai, {-0.02, 0.0, 0.0056}),
            sceneLibParameters(),
            cameraParameters(D::Davison, {-1.5e-6})};
}

/** Runs the check on each camera, and says which one failed. */
template <typename Check>
void forEachCamera(const Check& check)
{
    int index = 0;
    for (const CameraParameters& parameters : exampleCameras())
    {
        SCOPED_TRACE(name(parameters.distortion.model) + ", camera " + std::to_string(index++));
        check(Camera(parameters));
    }
}

/** Pixels along the four borders and on a grid inside. */
inline std::vector<Eigen::Vector2d> pixels(const Camera& camera)
{
    std::vector<Eigen::Vector2d> grid;
    const double right = camera.parameters().width_px - 1;
    const double bottom = camera.parameters().height_px - 1;
    for (int row = 0; row <= 12; ++row)
        for (int column = 0; column <= 16; ++column)
            grid.emplace_back(right * column / 16, bottom * row / 12);
    return grid;
}

/** A point up to the share of the largest valid angle off the axis. */
inline Eigen::Vector3d pointInView(std::mt19937& rng, const Camera& camera, double share)
{
    const double angle = uniform(rng, 0, share) * std::min(camera.maxAngle_rad(), 70 * kDegree);
    const double azimuth = uniform(rng, 0, 360 * kDegree);
    const Eigen::Vector3d direction(std::sin(angle) * std::cos(azimuth),
                                    std::sin(angle) * std::sin(azimuth), std::cos(angle));
    return uniform(rng, 0.3, 8.0) * direction;
}
}  // namespace monoslam
