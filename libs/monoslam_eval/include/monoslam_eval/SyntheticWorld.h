// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <random>
#include <vector>

#include "monoslam_eval/PixelFeatures.h"
#include "monoslam_eval/export.h"
#include "monoslam_models/Camera.h"
#include "monoslam_models/ConstantVelocity.h"

namespace monoslam
{
struct SyntheticWorldOptions
{
    CameraParameters camera;
    double frame_s = 1.0 / 30.0;
    double sigma_px = 1.0;
    double detectionProbability = 1.0;  ///< of a landmark in the image
    double clutterPerImage = 0.0;  ///< features like one landmark that are not it, Poisson mean
    double minScore = 0.7;         ///< scores of clutter are uniform in [minScore, 1]
    double scoreDecay = 12.0;  ///< those of true images fall there like exp(-scoreDecay (1 - s))
};

/** Repetitive texture: a group of landmarks that are all seen where they are not, alike, with the
 *  scores of true images. */
struct WrongMatches
{
    std::vector<LandmarkId> landmarks;
    long firstFrame = 0;
    long frames = 0;
    Eigen::Vector2d offset_px = Eigen::Vector2d::Zero();  ///< of their wrong images
    Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();    ///< in the world, of a twin of the object
    bool trueHidden = true;  ///< the true image is not among the features
};

/** A landmark that leaves its place; from then on no image of it is right. */
struct LandmarkMotion
{
    LandmarkId landmark = -1;
    long firstFrame = 0;
    Eigen::Vector3d v_w = Eigen::Vector3d::Zero();  ///< [m/s]
};

/** Landmarks without images: true pixels plus noise, missed detections, clutter and wrong matches, so
 *  that what a filter or a strategy does can be compared with the truth (algorithms 10.6, tier T1).
 *  Landmark i has LandmarkId i. */
class MONOSLAM_EVAL_EXPORT SyntheticWorld
{
   public:
    /** \throw std::invalid_argument if an option is out of its range */
    SyntheticWorld(const SyntheticWorldOptions& options, unsigned seed);

    LandmarkId addLandmark(const Eigen::Vector3d& p_w);

    /** Adds the point that x_v sees at a uniformly drawn pixel, border_px inside the image, at
     *  the distance 1/rho from the camera. */
    LandmarkId addLandmarkInView(const Vector13d& x_v, double rho, double border_px);

    /** \throw std::out_of_range if a landmark is not of this world */
    void add(WrongMatches group);
    void add(const LandmarkMotion& motion);

    [[nodiscard]] const Eigen::Vector3d& position(LandmarkId id) const;
    [[nodiscard]] Eigen::Vector3d position(LandmarkId id, long frame) const;
    [[nodiscard]] const Camera& camera() const { return camera_; }
    [[nodiscard]] std::mt19937& rng() { return rng_; }

    /** Where x_v sees the landmark without noise; nothing outside the image. */
    [[nodiscard]] std::optional<Eigen::Vector2d> truePixel(const Vector13d& x_v,
                                                           LandmarkId id) const;

    /** truePixel() plus Gaussian noise. */
    [[nodiscard]] std::optional<Eigen::Vector2d> measure(const Vector13d& x_v, LandmarkId id);

    /** All features of one frame, from x_v, in the order of their rows. What is drawn depends on the
     *  seed, the frame and the landmark alone: a group of wrong matches leaves the noise of all
     *  others as it was. The time is frame * frame_s, in whole ticks of 100 ns as a rawlog has it. */
    [[nodiscard]] PixelFrame observe(const Vector13d& x_v, long frame) const;

   private:
    struct Moment
    {
        const Vector13d& x_v;
        long frame;
    };
    [[nodiscard]] const WrongMatches* groupOf(LandmarkId id, long frame) const;
    [[nodiscard]] bool hasMoved(LandmarkId id, long frame) const;
    [[nodiscard]] std::optional<Eigen::Vector2d> project(const Vector13d& x_v,
                                                         const Eigen::Vector3d& p_w) const;
    void addImages(const Moment& now, LandmarkId id, std::mt19937& rng, PixelFrame& frame) const;
    void addClutter(LandmarkId id, std::mt19937& rng, PixelFrame& frame) const;
    [[nodiscard]] PixelFeature feature(LandmarkId id, const Eigen::Vector2d& z, double score,
                                       LandmarkId truth) const;
    [[nodiscard]] double drawTrueScore(std::mt19937& rng) const;

    Camera camera_;
    SyntheticWorldOptions options_;
    unsigned seed_;
    std::mt19937 rng_;
    std::vector<Eigen::Vector3d> points_;
    std::vector<WrongMatches> groups_;
    std::vector<LandmarkMotion> motions_;
};
}  // namespace monoslam
