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
    Eigen::Matrix2d R;      ///< c sigma_I^2 (A' A + prior)^-1 + floor^2 I [px^2]
    double residual = 0.0;  ///< rms [grey levels]
    SlopeEstimate slope;    ///< what these pixels alone tell of it
};

/** Inverse-compositional alignment: translation, slope of the surface, gain and offset.
 *
 * Each step regresses the image samples on the fixed columns [T_x T_y grad T . E_0 d, grad T . E_1 d,
 * T, 1] with E_k = M^-1 dM/ds_k, the stretch of the patch with the slope s:
 *
 *     I(uv + W d) = g T(d + t + E(s) d) + b,   W <- W (1 + E)^-1,   uv <- uv - W t
 *
 * The slope has the patch's prior, so that it stays where the pixels do not show it (Baker and
 * Matthews 2004, Molton et al. 2004).  Without it a slanted surface shifts the match by up to 1 px.
 * \return nothing if it diverges, leaves the image or fits badly */
[[nodiscard]] MONOSLAM_VISION_EXPORT std::optional<AlignedPatch> alignPatch(
    const PreparedImage& image, const Patch& patch, const Eigen::Vector2d& start_px,
    const AlignOptions& options);
}  // namespace monoslam
