// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <string>

#include "LandmarkFinder.h"
#include "LostMaps.h"
#include "MapKeeper.h"
#include "MatchNoise.h"
#include "ReadoutEstimator.h"
#include "StartWindow.h"
#include "TrackingJudge.h"
#include "monoslam_slam/MonoSlam.h"
#include "monoslam_support/ThreadClock.h"
#include "startBelief.h"

namespace monoslam
{
/** The state of a run and the steps of process(). */
struct MonoSlam::Impl
{
    Impl(MonoSlamOptions o, const Camera& c, std::unique_ptr<Associator> a, FilterEngine e,
         unsigned seed)
        : options(std::move(o)),
          camera(c),
          associator(std::move(a)),
          engine(std::move(e)),
          rng(seed),
          keeper(options, camera, seed),
          noise(options.search),
          judge(options.map)
    {
        readout.startAt(camera.parameters().readout_s);
    }

    MonoSlamOptions options;
    Camera camera;
    std::unique_ptr<Associator> associator;
    FilterEngine engine;
    std::mt19937 rng;
    MapKeeper keeper;
    MatchNoise noise;
    ReadoutEstimator readout;
    TrackingJudge judge;
    Mixture mixture;
    double t_s = 0.0;
    bool anyFrame = false;
    std::optional<StartWindow> window;
    std::optional<WorldOrigin> origin;  ///< if there is something not known of it
    LostMaps lost;
    LastView lastView;
    int unlooked = 0;  ///< frames since the last look for a lost map
    int looksDue = 0;  ///< after a loss, in every frame
    double lastStep_s = std::numeric_limits<double>::infinity();  ///< between the last two frames
    bool afterGap = false;  ///< the prediction of this frame does not tell where to search
    ProblemObserver observer;

    void check(const Frame& frame) const;
    std::string start(const FrameContext& context, const cv::Mat& image);
    void noteView(const FrameContext& context, const FrameReport& report);
    void remember(double rho0);
    void restart(const FrameContext& context);
    [[nodiscard]] bool verify(const FrameContext& context, const LostMap& map,
                              const Belief& placed);
    [[nodiscard]] bool returnToLostMap(const FrameContext& context);
    void trackAndJudge(const FrameContext& context, double dt_s, bool returned, FrameReport& report,
                       ThreadClock& clock);
    void lose(const FrameContext& context, FrameReport& report, ThreadClock& clock);
    void enter(LostMap map, Belief placed);
    void predict(double dt_s);
    void track(const FrameContext& context, double dt_s, FrameReport& report, ThreadClock& clock);
    [[nodiscard]] Correction correct(const FrameContext& context, FrameReport& report);
    [[nodiscard]] VisibilityOptions visibility() const;
    [[nodiscard]] FrameView viewOf(LandmarkFinder& finder) const;
    [[nodiscard]] RecordedFrame recordProblem(long index, LandmarkFinder& finder) const;
    void refineStart(const FrameContext& context, const FrameReport& report);
    void summarize(FrameReport& report) const;

    [[nodiscard]] double birthSigma_px() const
    {
        return options.search.subpixel ? 2.0 * options.search.sigma_floor_px
                                       : options.search.sigma_px;
    }
    [[nodiscard]] bool startUnexplained() const
    {
        return window && window->lastInlierRatio() < options.start.accept_inlier_ratio;
    }
};
}  // namespace monoslam
