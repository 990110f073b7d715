// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "monoslam_models/Distortion.h"
#include "monoslam_models/export.h"

namespace monoslam
{
using Matrix23d = Eigen::Matrix<double, 2, 3>;

/** Calibration of one camera; pixels have their integer coordinates at their centres. */
struct CameraParameters
{
    int width_px = 640;
    int height_px = 480;
    double fx_px = 500.0;
    double fy_px = 500.0;
    double cx_px = 319.5;
    double cy_px = 239.5;
    DistortionParameters distortion;
    double readout_s = 0.0;  ///< rolling shutter: last row minus first row [s], 0 = global
};

/** Pinhole with distortion, both ways, with Jacobians.
 *
 * \throw std::invalid_argument if the parameters are unusable (size, focal length, a
 * distortion that is undefined or folds back inside a quarter of the image diagonal) */
class MONOSLAM_MODELS_EXPORT Camera
{
   public:
    Camera();
    explicit Camera(const CameraParameters& parameters);

    [[nodiscard]] const CameraParameters& parameters() const { return parameters_; }

    /** Changes the rolling shutter's readout alone.
     *  \throw std::invalid_argument if it is negative or not finite */
    void setReadout(double readout_s);

    /** Largest angle from the optical axis [rad] up to which project() is one to one. */
    [[nodiscard]] double maxAngle_rad() const { return maxAngle_rad_; }

    /** Pixel of a point or direction h_c in the camera frame, any scale.
     *  \return nothing behind the camera or beyond maxAngle_rad(); may lie outside the image */
    [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& h_c,
                                                         Matrix23d* J_uv_h = nullptr) const;

    /** Ray (x_n, y_n, 1) of a distorted pixel.
     *  \return nothing if the pixel lies beyond the valid part of the distortion model
     *  \param J_xn_uv  d(x_n, y_n)/d(u, v), 2 x 2 */
    [[nodiscard]] std::optional<Eigen::Vector3d> unproject(
        const Eigen::Vector2d& uv_px, Eigen::Matrix2d* J_xn_uv = nullptr) const;

    /** Inside the image by at least border_px on all sides. */
    [[nodiscard]] bool contains(const Eigen::Vector2d& uv_px, double border_px = 0.0) const;

   private:
    CameraParameters parameters_;
    double maxAngle_rad_ = 0.0;
    double maxTan2_ = 0.0;  ///< tan(maxAngle)^2, compared with x_n^2 + y_n^2
};
}  // namespace monoslam
