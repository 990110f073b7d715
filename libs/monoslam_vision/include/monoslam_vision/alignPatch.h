// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "monoslam_vision/Patch.h"
#include "monoslam_vision/PreparedImage.h"
#include "monoslam_vision/export.h"

namespace monoslam
{
struct AlignOptions
{
    int maxIterations = 8;
    double convergence_px = 0.01;
    double maxMove_px = 1.5;         ///< from the integer peak
    double sigmaFloor_px = 0.1;      ///< added in quadrature to the noise
    double noiseCorrelation = 6.16;  ///< 4 pi s^2: smoothing by s = 0.7 px makes the noise of
                                     ///< neighbouring pixels alike; 1 = white
    double maxResidual = 0.5;        ///< residual deviation over the patch's, after gain and offset
};

struct AlignedPatch
{
    Eigen::Vector2d uv_px;
    Eigen::Matrix2d
        R;  ///< c sigma_I^2 (sum grad grad')^-1 + floor^2 I, c = noiseCorrelation [px^2]
    double residual = 0.0;  ///< rms [grey levels]
};

/** Inverse-compositional alignment: translation, gain and offset of the patch to the image.
 *
 * Each step regresses the image samples on the fixed columns [T_x T_y T 1]; their normal matrix is
 * factorised once.  I(p + d) = a T(p + delta) + b,  d <- d - delta   (Baker and Matthews 2004).
 * \return nothing if it diverges, leaves the image or fits badly */
[[nodiscard]] MONOSLAM_VISION_EXPORT std::optional<AlignedPatch> alignPatch(
    const PreparedImage& image, const Patch& patch, const Eigen::Vector2d& start_px,
    const AlignOptions& options);
}  // namespace monoslam
