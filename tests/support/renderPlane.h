// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "monoslam_models/Camera.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
/** 400 x 300, about 71 degrees wide, barrel distortion. */
inline Camera wideCamera()
{
    CameraParameters p;
    p.width_px = 400;
    p.height_px = 300;
    p.fx_px = 280.0;
    p.fy_px = 284.0;
    p.cx_px = 197.3;
    p.cy_px = 152.1;
    p.distortion.model = DistortionModel::Brown;
    p.distortion.k = {-0.28, 0.08, 1e-3, -5e-4, 0, 0, 0, 0};
    return Camera(p);
}

/** Exact pixels of points that the camera sees. */
inline std::vector<Eigen::Vector2d> seenBy(const Camera& camera,
                                           const Eigen::Matrix<double, 7, 1>& pose,
                                           const std::vector<Eigen::Vector3d>& points)
{
    std::vector<Eigen::Vector2d> pixels;
    for (const auto& p : points)
        pixels.push_back(*camera.project(rotateInverse(pose.tail<4>(), p - pose.head<3>())));
    return pixels;
}

/** A plane with a picture on it: p_w = R_wp (x, y, 0) + r_wp. */
struct PaintedPlane
{
    std::function<double(double x_m, double y_m)> light;  ///< 0 .. 1
    Eigen::Matrix3d R_wp = Eigen::Matrix3d::Identity();
    Eigen::Vector3d r_wp = Eigen::Vector3d::Zero();
};

struct Sensor
{
    double blur_px = 0.6;  ///< of the lens, mixes light before the sensor encodes it
    double noise_grey = 2.0;
    bool srgb = true;  ///< else grey levels are proportional to light
    unsigned seed = 1;
};

inline double encoded(double light, bool srgb)
{
    if (!srgb) return light;
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

/** Image of a plane by ray casting: every pixel is a weighted mean over the lens's blur and its own
 *  area, along true (distorted) rays. */
inline cv::Mat renderPlane(const PaintedPlane& plane, const Camera& camera,
                           const Eigen::Matrix<double, 7, 1>& pose, const Sensor& sensor)
{
    const auto& p = camera.parameters();
    const Eigen::Matrix3d R_pc = plane.R_wp.transpose() * rotationMatrix(pose.tail<4>());
    const Eigen::Vector3d r_pc = plane.R_wp.transpose() * (pose.head<3>() - plane.r_wp);
    const double sigma_px = std::hypot(sensor.blur_px, std::sqrt(1.0 / 12.0));
    std::mt19937 rng(sensor.seed);
    std::normal_distribution<double> noise(0.0, std::max(sensor.noise_grey, 1e-12));
    cv::Mat image(p.height_px, p.width_px, CV_8UC1);
    for (int v = 0; v < p.height_px; ++v)
        for (int u = 0; u < p.width_px; ++u)
        {
            Eigen::Matrix2d J;
            const auto ray = camera.unproject(Eigen::Vector2d(u, v), &J);
            const auto lightAt = [&](double du, double dv)
            {
                if (!ray) return 0.0;
                const Eigen::Vector2d x = ray->head<2>() + J * Eigen::Vector2d(du, dv);
                const Eigen::Vector3d d = R_pc * x.homogeneous();
                const double depth = -r_pc.z() / d.z();
                if (!(depth > 0)) return 0.0;
                return plane.light(r_pc.x() + depth * d.x(), r_pc.y() + depth * d.y());
            };
            const double reach_px = 3.0 * sigma_px;
            double light = lightAt(0, 0);
            const bool flat = light == lightAt(reach_px, 0) && light == lightAt(-reach_px, 0) &&
                              light == lightAt(0, reach_px) && light == lightAt(0, -reach_px);
            double sum = 0.0;
            double weights = 0.0;
            for (int i = -7; i <= 7 && !flat; ++i)
                for (int j = -7; j <= 7; ++j)
                {
                    const double a = (i + 0.03) / 7.0 * reach_px;
                    const double b = (j + 0.04) / 7.0 * reach_px;
                    const double weight = std::exp(-0.5 * (a * a + b * b) / (sigma_px * sigma_px));
                    sum += weight * lightAt(a, b);
                    weights += weight;
                }
            if (!flat) light = sum / weights;
            image.at<unsigned char>(v, u) =
                cv::saturate_cast<unsigned char>(255.0 * encoded(light, sensor.srgb) + noise(rng));
        }
    return image;
}

/** A camera at `from` that looks at `at`, rolled about its axis. */
inline Eigen::Matrix<double, 7, 1> lookAt(const Eigen::Vector3d& from, const Eigen::Vector3d& at,
                                          double roll_rad = 0.0)
{
    const Eigen::Vector3d z = (at - from).normalized();
    const Eigen::Vector3d side =
        std::abs(z.z()) > 0.999 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d x0 = z.cross(side).normalized();
    const Eigen::Vector3d y0 = z.cross(x0);
    Eigen::Matrix3d R;
    R.col(0) = std::cos(roll_rad) * x0 + std::sin(roll_rad) * y0;
    R.col(1) = -std::sin(roll_rad) * x0 + std::cos(roll_rad) * y0;
    R.col(2) = z;
    return (Eigen::Matrix<double, 7, 1>() << from, quaternionFromMatrix(R)).finished();
}
}  // namespace monoslam
