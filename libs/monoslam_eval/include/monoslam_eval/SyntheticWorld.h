// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <random>
#include <vector>

#include "monoslam_association/Associator.h"
#include "monoslam_eval/export.h"
#include "monoslam_models/Camera.h"
#include "monoslam_models/ConstantVelocity.h"

namespace monoslam
{
struct SyntheticWorldOptions
{
    CameraParameters camera;
    double sigma_px = 1.0;
    double detectionProbability = 1.0;  ///< of a visible landmark in its search region
    double clutterPerSearch = 0.0;      ///< mean number of wrong candidates in a search region
};

/** Landmarks without images: true pixels plus noise, so that what a filter or a strategy does can
 *  be compared with the truth. Landmark i has LandmarkId i. */
class MONOSLAM_EVAL_EXPORT SyntheticWorld
{
   public:
    SyntheticWorld(const SyntheticWorldOptions& options, unsigned seed);

    LandmarkId addLandmark(const Eigen::Vector3d& p_w);

    /** Adds the point that x_v sees at a uniformly drawn pixel, border_px inside the image, at
     *  the distance 1/rho from the camera. */
    LandmarkId addLandmarkInView(const Vector13d& x_v, double rho, double border_px);

    [[nodiscard]] const Eigen::Vector3d& position(LandmarkId id) const;
    [[nodiscard]] const Camera& camera() const { return camera_; }
    [[nodiscard]] std::mt19937& rng() { return rng_; }

    /** Where x_v sees the landmark without noise; nothing outside the image. */
    [[nodiscard]] std::optional<Eigen::Vector2d> truePixel(const Vector13d& x_v,
                                                           LandmarkId id) const;

    /** truePixel() plus Gaussian noise. */
    [[nodiscard]] std::optional<Eigen::Vector2d> measure(const Vector13d& x_v, LandmarkId id);

    /** What a strategy may ask of the frame taken from x_v. A landmark keeps its noisy pixel,
     *  found or missed, and its clutter keeps their ranks, for the life of the view, which must
     *  not outlive the world. */
    [[nodiscard]] FrameView view(const Vector13d& x_v, const VisibilityOptions& visibility);

   private:
    Camera camera_;
    SyntheticWorldOptions options_;
    std::mt19937 rng_;
    std::vector<Eigen::Vector3d> points_;
};

/** One true step of the filter's own process model: impulses drawn from Q, then f(x_v, dt). */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Vector13d drawMotion(const Vector13d& x_v, double dt_s,
                                                        const ConstantVelocityOptions& options,
                                                        std::mt19937& rng);

/** A camera drawn from N(x_v, P_v): the orientation error has three numbers, as T P T' says. */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Vector13d drawCamera(const Vector13d& x_v, const Matrix13d& P_v,
                                                        std::mt19937& rng);

/** Smooth hand-held-like 6-DoF path about the origin, looking along +z: sums of sines of the given
 *  amplitude [m], rotations up to 0.3 rad. */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Vector13d smoothPath(double t_s, double amplitude);
}  // namespace monoslam
