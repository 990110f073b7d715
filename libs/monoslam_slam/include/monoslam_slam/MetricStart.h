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
    Eigen::Vector2d rectangle_size_m{0.21, 0.1485};  ///< along the world's x and y
    Eigen::Vector2i chessboard_inner_corners{9, 6};  ///< along the world's x and y
    double chessboard_square_m = 0.04;
    double corner_sigma_px = 0.2;   ///< of a refined corner
    double point_sigma_m = 0.0005;  ///< of the known points in the world

    static MetricStartOptions from(ConfigSection section);
};

/** A camera pose from four known points, with all cross terms. */
struct MetricPose
{
    Vector7d pose;                           ///< (r_wc, q_wc)
    Eigen::Matrix<double, 7, 7> P;           ///< of it
    std::vector<Eigen::Vector3d> points_m;   ///< the four points in the world
    std::vector<Eigen::Vector2d> pixels_px;  ///< where they were seen, refined
    std::vector<double> sigmas_px;           ///< of each; large where no corner was found
    Eigen::Matrix<double, 7, Eigen::Dynamic> P_pose_points;  ///< cov(pose, points), 7 x 12
    double residualRms_px = 0.0;
    double scaleSigma = 0.0;  ///< relative std of the distance to the target
};

/** What became of the search for a target in one image. */
struct MetricStartResult
{
    std::optional<MetricPose> found;
    std::string reason;  ///< why not; with a pose: a remark, or empty
};

/** Looks for the target in one image; call it on each frame until it is found.
 *
 * Refines the target's corners, solves planar PnP from both tilts and derives the covariance
 * (algorithms 3.9). Nothing is found, and `reason` says why, if the corners do not fit the known
 * points or both tilts fit alike; with a pose, `reason` is a remark or empty. Conventions:
 *  - target_points: the points' own world. All four are the corners of a filled quadrilateral if
 *    its sides show as edges; else each is the corner next to its rough pixel. Where there is no
 *    corner, the rough pixel is used with 2 px and `reason` says so.
 *  - rectangle: the world's centre is the rectangle's, z = 0, the camera is above (z > 0). The
 *    side lengths tell x from y; of the two half turns the camera's x axis is as near as possible
 *    to the world's. Of several rectangles the largest that fits.
 *  - chessboard: inner corner (0, 0) is the origin, x along the first count, y along the second,
 *    z = x cross y points away from the camera (into the board). Of the two half turns the one
 *    whose x axis points more to the right in the image. Only the four outer inner-corners count.
 * \throw std::invalid_argument if the image is not CV_8UC1 of the camera's size */
[[nodiscard]] MONOSLAM_SLAM_EXPORT MetricStartResult
findMetricPose(const cv::Mat& image, const Camera& camera, const MetricStartOptions& options);

/** The geometry alone: pose from target_points_m of the options, seen at pixels_px with
 *  corner_sigma_px. */
[[nodiscard]] MONOSLAM_SLAM_EXPORT MetricStartResult
metricPoseFrom(const std::vector<Eigen::Vector2d>& pixels_px, const Camera& camera,
               const MetricStartOptions& options);
}  // namespace monoslam
