// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "monoslam_vision/CornerTracker.h"
#include "mosaic.h"

/** A camera that moves over a mosaic, and corners to be followed in its images. */
namespace monoslam
{
inline constexpr double kSide_m = 0.07;
inline constexpr double kSmoothing_px = 0.7;

/** Frame k of a camera half a metre above the plane that moves sideways, a centimetre a frame. It
 *  looks straight down: so the plane is what the tracker assumes of a corner's surroundings. */
inline Vector7d poseOf(int k)
{
    return lookAt({-0.04 + 0.01 * k, -0.02, 0.5 + 0.002 * k}, {0.01 * k - 0.02, 0.0, 0.0},
                  0.01 * k);
}

inline std::shared_ptr<const PreparedImage> imageOf(const PaintedPlane& plane, const Vector7d& pose,
                                                    unsigned seed)
{
    Sensor sensor;
    sensor.seed = seed;
    return prepareImage(renderPlane(plane, smallCamera(), pose, sensor), kSmoothing_px);
}

inline std::shared_ptr<const PreparedImage> frameOf(int k)
{
    return imageOf(mosaic(kSide_m), poseOf(k), static_cast<unsigned>(k + 1));
}

inline std::shared_ptr<const PreparedImage> blank()
{
    return prepareImage(cv::Mat(180, 240, CV_8UC1, cv::Scalar(90)), kSmoothing_px);
}

inline Belief beliefAt(const Vector7d& pose)
{
    Vector13d x_v = Vector13d::Zero();
    x_v.head<7>() = pose;
    return Belief::ofCamera(x_v, 1e-8 * Matrix13d::Identity());
}

inline Eigen::Vector2d pixelOf(const Eigen::Vector3d& p_w, const Vector7d& pose)
{
    return seenBy(smallCamera(), pose, {p_w}).front();
}

/** A corner born in frame 0 with an inverse depth that is wrong by a factor. */
inline TrackedCorner newborn(const Eigen::Vector3d& p_w, std::shared_ptr<const PreparedImage> image,
                             double factor = 1.3)
{
    TrackedCorner corner;
    corner.id = 3;
    corner.uv_px = pixelOf(p_w, poseOf(0));
    corner.born = {std::move(image), corner.uv_px, poseOf(0), {}};
    corner.first.pose = poseOf(0);
    corner.first.uv_px = corner.uv_px;
    corner.rho = factor / (p_w - poseOf(0).head<3>()).norm();
    corner.sigma_rho = 0.5 * corner.rho;
    return corner;
}

inline std::optional<TrackedCorner> track(const TrackedCorner& corner, const Belief& belief,
                                          const PreparedImage& image, long frame = 1,
                                          const CornerTrackerOptions& options = {})
{
    return trackCorner(corner, belief, smallCamera(), image, frame, options);
}
}  // namespace monoslam
