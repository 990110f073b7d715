// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "DepthPictures.h"
#include "monoslam_eval/Trajectory.h"
#include "monoslam_models/Camera.h"

namespace monoslam
{
struct TruePoint
{
    Eigen::Vector3d p_w;      ///< [m]
    double distance_m = 0.0;  ///< from the camera that saw it
};

/** The surface points that pixels of a sequence show, from true poses and depth pictures. */
class LandmarkTruth
{
   public:
    /** \param truth  one pose a frame: row i is that of depth picture i
     *  \param depthFolder  see DepthPictures; not every frame needs a picture
     *  \throw std::invalid_argument if the folder does not exist */
    LandmarkTruth(Trajectory truth, const CameraParameters& camera, const std::string& depthFolder);

    /** Point that the frame of time t_s shows at a pixel.
     *
     * Without a depth picture of that frame it is where the pixel's ray first meets the surface that
     * the nearest picture within ten frames shows.
     * \return nothing without a pose at that time, without depth, or if the ray does not meet it */
    [[nodiscard]] std::optional<TruePoint> point(double t_s, const Eigen::Vector2d& uv_px);

   private:
    /** \param ray_c  of the pixel uv of a frame */
    [[nodiscard]] std::optional<Eigen::Vector3d> pointOn(const Eigen::Vector3d& ray_c,
                                                         const Eigen::Vector2d& uv, long frame);
    [[nodiscard]] std::optional<Eigen::Vector3d> meet(const StampedPose& from,
                                                      const Eigen::Vector3d& ray_c, long picture);
    /** How far a point lies behind the surface of a picture, relative to its depth. */
    [[nodiscard]] std::optional<double> behind(const Eigen::Vector3d& p_w, long picture);

    Trajectory truth_;
    Camera camera_;
    DepthPictures depths_;
};
}  // namespace monoslam
