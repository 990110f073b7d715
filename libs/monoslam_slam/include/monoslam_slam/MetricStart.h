// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "monoslam_models/Camera.h"
#include "monoslam_models/ConstantVelocity.h"
#include "monoslam_slam/export.h"

namespace monoslam
{
class ConfigSection;

enum class MetricStartMethod
{
    None,          ///< free scale
    TargetPoints,  ///< four known coplanar points, rough pixels given
    Rectangle,     ///< a dark rectangle of known size, found in the image
    Chessboard,    ///< the four outer inner-corners of a board
};

/** Options of ini section [metric_start]. */
struct MONOSLAM_SLAM_EXPORT MetricStartOptions
{
    MetricStartMethod method = MetricStartMethod::None;
    std::vector<Eigen::Vector3d> target_points_m;   ///< world, on one plane, any order
    std::vector<Eigen::Vector2d> target_points_px;  ///< rough pixels in the first frame, same order
    Eigen::Vector2d rectangle_size_m{0.21, 0.1485};  ///< along the world's x and y; centre at the origin, z = 0
    Eigen::Vector2i chessboard_inner_corners{9, 6};
    double chessboard_square_m = 0.04;  ///< corner (0, 0) is the world's origin, x along the first count
    double corner_sigma_px = 0.2;       ///< of a refined corner
    double point_sigma_m = 0.0005;      ///< of the known points in the world

    static MetricStartOptions from(ConfigSection section);
};

/** A camera pose from four known points, with all cross terms. */
struct MetricPose
{
    Vector7d pose;                           ///< (r_wc, q_wc)
    Eigen::Matrix<double, 7, 7> P;           ///< of it
    std::vector<Eigen::Vector3d> points_m;   ///< the four points in the world
    std::vector<Eigen::Vector2d> pixels_px;  ///< where they were seen, refined
    double residualRms_px = 0.0;
    double scaleSigma = 0.0;                 ///< relative std of the distance to the target
};

/** What became of the search for a target in one image. */
struct MetricStartResult
{
    std::optional<MetricPose> found;
    std::string reason;  ///< why not
};

/** Looks for the target, refines its corners, solves planar PnP (both solutions) and derives the
 *  covariance (algorithms 3.9). Outlier-proof: refuses when the residual or the ambiguity is bad. */
[[nodiscard]] MONOSLAM_SLAM_EXPORT MetricStartResult findMetricPose(
    const cv::Mat& image, const Camera& camera, const MetricStartOptions& options);
}  // namespace monoslam
