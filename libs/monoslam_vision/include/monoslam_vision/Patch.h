// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "monoslam_models/ConstantVelocity.h"
#include "monoslam_vision/PreparedImage.h"
#include "monoslam_vision/SurfaceSlope.h"
#include "monoslam_vision/export.h"

namespace monoslam
{
/** How a landmark looked when it was born: the image, the pixel and the camera pose of then. */
struct Appearance
{
    std::shared_ptr<const PreparedImage> image;
    Eigen::Vector2d uv_px;
    Vector7d pose;       ///< (r_wc, q_wc) as estimated then
    SurfaceSlope slope;  ///< of its surface, learnt since
};

/** How pixel offsets now map to pixel offsets in the birth image, and how that changes with the
 *  slope s of the surface: M(s + d) = M + dM/ds_0 d_0 + dM/ds_1 d_1. */
struct PredictedWarp
{
    Eigen::Matrix2d M = Eigen::Matrix2d::Identity();
    std::array<Eigen::Matrix2d, 2> J_M_s{Eigen::Matrix2d::Zero(), Eigen::Matrix2d::Zero()};
    SlopeEstimate slope;  ///< that M was made with
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
    std::array<Eigen::Matrix2d, 2> stretch{Eigen::Matrix2d::Zero(),
                                           Eigen::Matrix2d::Zero()};  ///< M^-1 dM/ds
    SlopeEstimate slope;

    [[nodiscard]] int side() const { return 2 * half_px + 1; }
    [[nodiscard]] float at(int dx, int dy) const
    {
        const int ringSide = side() + 2;
        const int index = (dy + half_px + 1) * ringSide + dx + half_px + 1;
        return grey[static_cast<std::size_t>(index)];
    }
};

/** Samples the birth image through a warp, at the pyramid level that avoids aliasing.
 *  \return nothing if the warped patch leaves the birth image */
[[nodiscard]] MONOSLAM_VISION_EXPORT std::optional<Patch> samplePatch(const Appearance& born,
                                                                      const PredictedWarp& warp,
                                                                      int half_px);
}  // namespace monoslam
