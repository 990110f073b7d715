// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "edgeQuad.h"
#include "monoslam_models/Camera.h"
#include "monoslam_slam/MetricStart.h"
#include "refinePose.h"

namespace monoslam
{
/** The target's points in one image, or why they were not found. */
struct TargetSearch
{
    std::optional<SeenPoints> seen;
    std::string note;  ///< with `seen`: what was done without; else why nothing was found
};

/** The given points, each refined to the corner next to its rough pixel.
 *
 * If the four sides between them are straight edges, the corners are where the fitted lines meet
 * (edgeQuad.h). Else cornerSubPix, in a window of 3 to 8 px that scales with the target. A corner
 * that leaves the window, or a place that is no corner, keeps the given pixel with sigma 2 px. */
[[nodiscard]] TargetSearch refineTargetPoints(const cv::Mat& image, const Camera& camera,
                                              const MetricStartOptions& options);

/** The four outer inner-corners of a chessboard. */
[[nodiscard]] TargetSearch findChessboard(const cv::Mat& image, const MetricStartOptions& options);

/** Dark convex quadrilaterals wholly inside the image, largest first, corners to about a pixel,
 *  against the clock as seen in the image (y down): as a rectangle is seen from above. */
[[nodiscard]] std::vector<Quad> findDarkQuads(const cv::Mat& image, const Camera& camera);

/** A corner near a rough pixel, by shrinking cornerSubPix windows.
 *  \return nothing if there is no corner, or it lies outside the window */
[[nodiscard]] std::optional<Eigen::Vector2d> refineCorner(const cv::Mat& image,
                                                          const Eigen::Vector2d& rough_px,
                                                          int window_px);
}  // namespace monoslam
