// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include "monoslam_models/export.h"

namespace monoslam
{
enum class DistortionModel
{
    None,
    Brown,          ///< "plumb_bob": k1 k2 p1 p2 k3 [k4 k5 k6]; undistorted to distorted
    KannalaBrandt,  ///< OpenCV fisheye, equidistant: k1 k2 k3 k4; undistorted to distorted
    Tsai,           ///< Civera: k1 k2 [mm^-2, mm^-4], pixel size d [mm]; distorted to undistorted
    Davison,        ///< SceneLib: K1 [px^-2], closed form both ways
};

struct DistortionParameters
{
    DistortionModel model = DistortionModel::None;
    /** Brown: k1 k2 p1 p2 k3 k4 k5 k6 (OpenCV's and MRPT's order). KannalaBrandt: k1 k2 k3 k4.
     *  Tsai: k1 k2 d_mm. Davison: K1. */
    std::array<double, 8> k{};
};

/** Names as in the ini: none, brown, kannala_brandt, tsai, davison. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT std::string name(DistortionModel model);

/** Focal lengths, which the models that work in pixels (Tsai, Davison) need. */
struct FocalLengths
{
    double fx_px = 1.0;
    double fy_px = 1.0;
};

/** Distorts normalised coordinates x_n = (x/z, y/z) to normalised distorted coordinates.
 *  \return nothing where the model is undefined */
[[nodiscard]] MONOSLAM_MODELS_EXPORT std::optional<Eigen::Vector2d> distort(
    const DistortionParameters& parameters, FocalLengths f, const Eigen::Vector2d& x_n,
    Eigen::Matrix2d* J_xd_xn = nullptr);

/** Inverse of distort(), by Newton steps where there is no closed form.
 *  \return nothing where no undistorted point was found; one beyond maxAngle() is for the caller to
 *  refuse, as Camera::unproject() does */
[[nodiscard]] MONOSLAM_MODELS_EXPORT std::optional<Eigen::Vector2d> undistort(
    const DistortionParameters& parameters, FocalLengths f, const Eigen::Vector2d& x_d,
    Eigen::Matrix2d* J_xn_xd = nullptr);

/** Angle from the axis [rad] up to which the radial part is increasing and invertible; at most
 *  89 degrees. */
[[nodiscard]] MONOSLAM_MODELS_EXPORT double maxAngle(const DistortionParameters& parameters,
                                                     FocalLengths f);
}  // namespace monoslam
