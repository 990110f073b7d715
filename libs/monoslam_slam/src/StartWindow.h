// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "LandmarkRecord.h"
#include "monoslam_association/Associator.h"
#include "monoslam_filter/smoothWindow.h"
#include "monoslam_models/Camera.h"
#include "monoslam_slam/StartOptions.h"
#include "startWindowProblem.h"

namespace monoslam
{
/** What the first seconds say when they are all looked at at once. */
struct RefinedStart
{
    Belief belief;
    std::vector<LandmarkId> distrusted;  ///< landmarks that explain too few of their pixels
};

/** The first seconds of a run, kept until their parallax fixes the structure.
 *
 * An EKF that starts from unknown depths linearises at its worst estimates and keeps what it
 * wrongly learnt then. While the window is open all pixels are kept; each time the median parallax
 * since the first frame passes a threshold, poses and landmarks are estimated anew from all of them
 * (smoothWindow) and the belief is rebuilt, mean and covariance, from that. */
class StartWindow
{
   public:
    /** Keeps a reference to the camera. */
    StartWindow(const StartOptions& options, const Camera& camera, bool metric)
        : options_(options), camera_(camera), metric_(metric)
    {
    }

    [[nodiscard]] bool open() const { return open_; }

    /** Keeps the frame's pose and pixels: matched, rejected and newborn ones. */
    void record(double t_s, long frame, const Belief& belief,
                const std::vector<Association>& associations, const LandmarkRecords& records,
                double sigma_px);

    /** The belief estimated anew, if a threshold has been passed; closes after the last one. */
    [[nodiscard]] std::optional<RefinedStart> refine(const Belief& belief,
                                                     const LandmarkRecords& records,
                                                     const ConstantVelocityOptions& motion);

    /** Share of the window's pixels that the last estimate explains; low after a wrong start. */
    [[nodiscard]] double lastInlierRatio() const { return lastInlierRatio_; }

   private:
    enum class Look
    {
        Not,
        ForEstimate,
        ForOther,  ///< only whether the pixels show another structure than the filter's
    };
    /** By the filter's own structure, of what the last view sees since the first. */
    [[nodiscard]] double seenParallax_deg(const Belief& belief) const;
    /** For an estimate before the first threshold. */
    [[nodiscard]] bool enough(double parallax_deg) const;
    [[nodiscard]] Look due(double parallax_deg) const;
    void passThresholds(double parallax_deg);
    /** \param ownGuess  set to false if another guess than the window's has won */
    [[nodiscard]] SmoothedWindow smooth(const Window& window, bool& ownGuess) const;

    StartOptions options_;
    const Camera& camera_;
    bool metric_;
    bool open_ = true;
    std::size_t nextThreshold_ = 0;
    std::vector<StartView> views_;
    std::size_t lastLook_ = 0;
    double lastInlierRatio_ = 1.0;
    double leastCost_ = std::numeric_limits<double>::infinity();  ///< of a pixel, of all estimates
};
}  // namespace monoslam
