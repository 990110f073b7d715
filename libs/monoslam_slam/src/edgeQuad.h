// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "edgeModel.h"
#include "monoslam_models/Camera.h"

namespace monoslam
{
/** Corners of a quadrilateral, in order around it, as distorted pixels. */
using Quad = std::array<Eigen::Vector2d, 4>;

struct EdgeQuad
{
    Quad corners_px;
    EdgeFit fit;
};

/** Corners of a filled quadrilateral from lines fitted to its four sides.
 *
 * The lines are straight in undistorted coordinates; all pixels within a few pixels of a side and
 * away from its ends take part (edgeModel.h), so that neither the rounding of corners by the lens
 * nor a stray pixel matters. Typical error 0.02 to 0.05 px.
 * \param rough_px  corners to within about 3 px
 * \return nothing if a side is not one straight edge with contrast all along */
[[nodiscard]] std::optional<EdgeQuad> refineEdgeQuad(const cv::Mat& image, const Camera& camera,
                                                     const Quad& rough_px);
}  // namespace monoslam
