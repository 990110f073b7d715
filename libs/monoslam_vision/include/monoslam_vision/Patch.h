// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "monoslam_models/Camera.h"
#include "monoslam_models/ConstantVelocity.h"
#include "monoslam_vision/PreparedImage.h"
#include "monoslam_vision/export.h"

namespace monoslam
{
/** How a landmark looked when it was born: the image, the pixel and the camera pose of then. */
struct Appearance
{
    std::shared_ptr<const PreparedImage> image;
    Eigen::Vector2d uv_px;
    Vector7d pose;  ///< (r_wc, q_wc) as estimated then
};

/** A landmark's expected appearance in one frame, sampled on the pixel grid around its centre. */
struct Patch
{
    int half_px = 0;                    ///< (2 half + 1)^2 pixels
    std::vector<float> grey;            ///< with a ring of one pixel around, for gradients
    std::vector<std::int16_t> centred;  ///< zero mean, fixed point, rows padded to a block
    int stride = 0;                     ///< of centred
    double centredSum = 0.0;            ///< of centred: what rounding left of its mean
    double norm = 0.0;                  ///< of centred about its mean
    double deviation = 0.0;             ///< standard deviation of the pixels [grey levels]

    [[nodiscard]] int side() const { return 2 * half_px + 1; }
    [[nodiscard]] float at(int dx, int dy) const
    {
        const int ringSide = side() + 2;
        return grey[static_cast<std::size_t>((dy + half_px + 1) * ringSide + dx + half_px + 1)];
    }
};

/** Limits beyond which an appearance cannot be predicted. */
struct WarpLimits
{
    double maxScale = 2.0;          ///< and not below its inverse
    double maxViewAngle_rad = 0.8;  ///< between the two viewing directions
};

/** 2 x 2 map from pixel offsets now to pixel offsets in the birth image, for a small plane through
 *  p_w that faces the bisector of both viewing directions; finite differences of the full
 *  projection, lens included (algorithms 4.3).
 *  \return nothing if the view has changed too much */
[[nodiscard]] MONOSLAM_VISION_EXPORT std::optional<Eigen::Matrix2d> predictWarp(
    const Camera& camera, const Appearance& born, const Vector7d& pose, const Eigen::Vector3d& p_w,
    const WarpLimits& limits);

/** Samples the birth image through a warp, at the pyramid level that avoids aliasing.
 *  \return nothing if the warped patch leaves the birth image */
[[nodiscard]] MONOSLAM_VISION_EXPORT std::optional<Patch> samplePatch(const Appearance& born,
                                                                      const Eigen::Matrix2d& warp,
                                                                      int half_px);
}  // namespace monoslam
