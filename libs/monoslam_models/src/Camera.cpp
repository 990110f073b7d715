// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_models/Camera.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <string>

namespace monoslam
{
namespace
{
void require(bool condition, const std::string& message)
{
    if (!condition) throw std::invalid_argument("camera: " + message);
}

void requirePositive(double value, const std::string& name)
{
    require(std::isfinite(value) && value > 0, name + " must be > 0");
}

void checkReadout(double readout_s)
{
    require(std::isfinite(readout_s) && readout_s >= 0, "readout_s must be >= 0");
}

void checkNumbers(const CameraParameters& p)
{
    requirePositive(p.width_px, "width_px");
    requirePositive(p.height_px, "height_px");
    requirePositive(p.fx_px, "fx_px");
    requirePositive(p.fy_px, "fy_px");
    require(std::isfinite(p.cx_px), "cx_px must be finite");
    require(std::isfinite(p.cy_px), "cy_px must be finite");
    checkReadout(p.readout_s);
    for (const double k : p.distortion.k)
        require(std::isfinite(k), "distortion coefficients must be finite");
}

FocalLengths focalLengths(const CameraParameters& p)
{
    return {p.fx_px, p.fy_px};
}

/** The largest valid angle must lie at least a quarter diagonal from the principal point. */
void checkValidPart(const CameraParameters& p, double maxAngle_rad)
{
    const double quarter_px = 0.25 * std::hypot(p.width_px, p.height_px);
    const double reach = 0.999999 * std::tan(maxAngle_rad);
    const std::optional<Eigen::Vector2d> edge =
        distort(p.distortion, focalLengths(p), Eigen::Vector2d(reach, 0.0));
    const bool isWide = edge && p.fx_px * edge->norm() >= quarter_px;
    require(isWide, "distortion " + name(p.distortion.model) +
                        " folds back inside a quarter of the image diagonal");
}
}  // namespace

Camera::Camera() : Camera(CameraParameters{}) {}

Camera::Camera(const CameraParameters& parameters) : parameters_(parameters)
{
    checkNumbers(parameters_);
    maxAngle_rad_ = maxAngle(parameters_.distortion, focalLengths(parameters_));
    maxTan2_ = std::pow(std::tan(maxAngle_rad_), 2);
    checkValidPart(parameters_, maxAngle_rad_);
}

void Camera::setReadout(double readout_s)
{
    checkReadout(readout_s);
    parameters_.readout_s = readout_s;
}

std::optional<Eigen::Vector2d> Camera::project(const Eigen::Vector3d& h_c, Matrix23d* J_uv_h) const
{
    if (!(h_c.z() > 0)) return {};
    const double zInverse = 1.0 / h_c.z();
    const Eigen::Vector2d x_n = h_c.head<2>() * zInverse;
    if (!(x_n.squaredNorm() <= maxTan2_)) return {};

    Eigen::Matrix2d J_xd_xn;
    const std::optional<Eigen::Vector2d> x_d = distort(
        parameters_.distortion, focalLengths(parameters_), x_n, J_uv_h ? &J_xd_xn : nullptr);
    if (!x_d) return {};
    if (J_uv_h)
    {
        Matrix23d J_xn_h;
        J_xn_h << zInverse, 0.0, -x_n.x() * zInverse,  //
            0.0, zInverse, -x_n.y() * zInverse;
        const Eigen::Vector2d focal_px(parameters_.fx_px, parameters_.fy_px);
        const Eigen::Matrix2d J_uv_xn = focal_px.asDiagonal() * J_xd_xn;
        J_uv_h->noalias() = J_uv_xn * J_xn_h;
    }
    return Eigen::Vector2d(parameters_.fx_px * x_d->x() + parameters_.cx_px,
                           parameters_.fy_px * x_d->y() + parameters_.cy_px);
}

std::optional<Eigen::Vector3d> Camera::unproject(const Eigen::Vector2d& uv_px,
                                                 Eigen::Matrix2d* J_xn_uv) const
{
    const Eigen::Vector2d x_d((uv_px.x() - parameters_.cx_px) / parameters_.fx_px,
                              (uv_px.y() - parameters_.cy_px) / parameters_.fy_px);
    const std::optional<Eigen::Vector2d> x_n =
        undistort(parameters_.distortion, focalLengths(parameters_), x_d, J_xn_uv);
    if (!x_n || !(x_n->squaredNorm() <= maxTan2_)) return {};
    if (J_xn_uv)
    {
        J_xn_uv->col(0) /= parameters_.fx_px;
        J_xn_uv->col(1) /= parameters_.fy_px;
    }
    return x_n->homogeneous();
}

bool Camera::contains(const Eigen::Vector2d& uv_px, double border_px) const
{
    return uv_px.x() >= border_px && uv_px.x() <= parameters_.width_px - 1 - border_px &&
           uv_px.y() >= border_px && uv_px.y() <= parameters_.height_px - 1 - border_px;
}
}  // namespace monoslam
