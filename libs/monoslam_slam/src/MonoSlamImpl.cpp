// SPDX-License-Identifier: BSD-3-Clause
#include "MonoSlamImpl.h"

#include <stdexcept>
#include <utility>

#include "contradiction.h"
#include "dismissMatches.h"
#include "monoslam_association/fateCounts.h"
#include "postFitResiduals.h"
#include "predictionGap.h"

namespace monoslam
{
namespace
{
constexpr double kGap = 3.0;  ///< steps of the frame before: more is a gap in the recording
}  // namespace

void MonoSlam::Impl::check(const Frame& frame) const
{
    const CameraParameters& p = camera.parameters();
    const std::string where = "frame " + std::to_string(frame.index) + ": ";
    if (frame.image.type() != CV_8UC1)
        throw std::invalid_argument(where + "image is not 8-bit grey");
    if (frame.image.cols != p.width_px || frame.image.rows != p.height_px)
        throw std::invalid_argument(where + "image has " + std::to_string(frame.image.cols) +
                                    " x " + std::to_string(frame.image.rows) +
                                    " pixels, the camera has " + std::to_string(p.width_px) +
                                    " x " + std::to_string(p.height_px));
    if (anyFrame && !(frame.t_s > t_s))
        throw std::invalid_argument(where + "time does not increase");
}

/** Puts the first belief up; returns why that is not possible yet, or what is to be said of the
 *  target that was found. */
std::string MonoSlam::Impl::start(const FrameContext& context, const cv::Mat& image)
{
    std::string note;
    std::optional<MetricPose> target;
    if (options.metricStart.method != MetricStartMethod::None)
    {
        const MetricStartResult result = findMetricPose(image, camera, options.metricStart);
        note = result.reason;
        if (!result.found) return note;
        target = result.found;
        origin = WorldOrigin{target->pose, target->P};
    }
    StartBelief first = startBelief(target ? &*target : nullptr, options.initialization);
    mixture = {{std::move(first.belief), 0.0}};
    if (target) mixture = keeper.addKnownPoints(std::move(mixture), *target, context);
    mixture = keeper.addFirst(std::move(mixture), context, first.rho0, first.sigma_rho);
    if (!options.start.parallax_deg.empty())
        window.emplace(options.start, camera, target.has_value());
    return note;
}

VisibilityOptions MonoSlam::Impl::visibility() const
{
    const int half_px = options.search.patch_px / 2;
    return {half_px + 2.0, birthSigma_px()};
}

FrameView MonoSlam::Impl::viewOf(LandmarkFinder& finder) const
{
    FrameView view;
    view.predict = [this](const Belief& belief)
    { return predictMeasurements(belief, camera, visibility()); };
    view.linearize = [this](const Eigen::VectorXd& x, const LandmarkSlot& slot)
    { return linearizeLandmark(x, slot, camera, visibility()); };
    view.imageArea_px2 = 1.0 * camera.parameters().width_px * camera.parameters().height_px;
    view.search = [&finder](const SearchRegion& region) { return finder.search(region); };
    view.engine = engine;
    return view;
}

/** \param finder  of its own: what it has searched already would be told to the map otherwise */
RecordedFrame MonoSlam::Impl::recordProblem(long index, LandmarkFinder& finder) const
{
    RecordedFrame frame;
    frame.index = index;
    frame.mixture = mixture;
    frame.camera = camera;
    frame.visibility = visibility();
    frame.minScore = options.search.min_zncc;
    const FrameView view = viewOf(finder);
    return withAnswers(recordFrame(std::move(frame), view), view, *associator, rng);
}

/** Search, association and update from the predicted beliefs. */
Correction MonoSlam::Impl::correct(const FrameContext& context, FrameReport& report)
{
    const std::size_t expectedIndex = bestIndex(mixture);
    Belief expected = mixture[expectedIndex].belief;
    SearchOptions search = options.search;
    search.sigma_floor_px = noise.floor_px();
    if (observer)
        observer(context.index,
                 [&]
                 {
                     LandmarkFinder own(camera, *context.image, search, keeper.records(), expected);
                     return recordProblem(context.index, own);
                 });
    LandmarkFinder finder(camera, *context.image, search, keeper.records(), expected);
    const FrameView view = viewOf(finder);
    Correction correction = associator->correct(std::move(mixture), view, rng);
    report.contradicted = isContradicted(correction.associations, expected, view);
    // After a gap the shifted squares of a board match, too: half of the map has to be where it says.
    const bool unexplained = afterGap && !explainsFrame(countFates(correction.associations));
    if (report.contradicted || unexplained || mayBeChance(correction.associations, options.map))
        return dismissMatches(std::move(correction), std::move(expected), expectedIndex);
    keeper.learnSlopes(correction.associations, finder);
    return correction;
}

void MonoSlam::Impl::predict(double dt_s)
{
    const Matrix13d before = best(mixture).P.topLeftCorner<13, 13>();
    const Vector13d x_v = best(mixture).camera();
    const double rho = keeper.medianRho(best(mixture));
    for (auto& weighted : mixture)
        weighted.belief = engine.predict(std::move(weighted.belief), options.motion, dt_s);
    const double grown_rad = lineOfSightGrowth_rad(
        poseCovariance(x_v, before),
        poseCovariance(best(mixture).camera(), best(mixture).P.topLeftCorner<13, 13>()), rho);
    const double usual_s = dt_s > 0.0 ? std::exchange(lastStep_s, dt_s) : lastStep_s;
    afterGap = options.map.relocalize_every > 0 && dt_s > kGap * usual_s &&
               camera.parameters().fx_px * grown_rad > options.search.max_radius_px;
}

void MonoSlam::Impl::track(const FrameContext& context, double dt_s, FrameReport& report,
                           ThreadClock& clock)
{
    predict(dt_s);
    report.times.predict_ms = clock.lap_ms();

    Correction correction = correct(context, report);
    mixture = std::move(correction.mixture);
    report.counters = correction.counters;
    report.diversity = correction.diversity;
    report.times.search_ms = report.counters.searchMs;
    report.times.associate_ms = report.counters.selectMs;
    report.times.update_ms = clock.lap_ms() + report.counters.otherThreadsMs -
                             report.counters.searchMs - report.counters.selectMs;
    const Belief& belief = best(mixture);
    report.matched = static_cast<int>(countFates(correction.associations).matched);
    if (options.search.subpixel && report.matched > 0)  // else they are no residuals of a fit
        noise.adapt(settledResiduals(belief, camera, correction.associations, keeper.records()));
    keeper.noteResiduals(belief, correction.associations);
    if (options.estimateReadout)
    {
        readout.observe(belief, camera, correction.associations, noise.sigma_px());
        camera.setReadout(readout.readout_s());
    }
    report.residualRms_px = residualRms_px(belief, camera, correction.associations);
    mixture = keeper.revise(std::move(mixture), correction, context);
    report.associations = std::move(correction.associations);
    noteView(context, report);
}

/** Re-estimates the first seconds, where a wrong linearisation would stay for ever. Of several
 *  beliefs the one of largest weight is recorded and re-estimated, and the mixture is then that one:
 *  what the others would have linearised differently is what the estimate repairs. */
void MonoSlam::Impl::refineStart(const FrameContext& context, const FrameReport& report)
{
    if (!window || !window->open() || mixture.empty()) return;
    const Belief& belief = best(mixture);
    window->record(report.t_s, context.index, belief, report.associations, keeper.records(),
                   birthSigma_px());
    auto refined = window->refine(belief, keeper.records(), options.motion);
    if (refined)
    {
        mixture = {
            {keeper.addAgain(std::move(refined->belief), report.associations, refined->distrusted),
             0.0}};
        keeper.keepOnly(best(mixture));
    }
    keeper.setStarting(window->open());
}

void MonoSlam::Impl::summarize(FrameReport& report) const
{
    if (mixture.empty()) return;
    const Belief& belief = best(mixture);
    report.x_v = belief.camera();
    report.P_v = belief.P.topLeftCorner<13, 13>();
    if (origin) report.P_v.topLeftCorner<7, 7>() += worldCovariance(*origin, report.x_v.head<7>());
    report.readout_s = camera.parameters().readout_s;
    report.landmarks = static_cast<int>(belief.landmarks.size());
    report.visible = static_cast<int>(report.associations.size());
    report.candidates = keeper.candidates();
    report.added = keeper.added();
    report.removed = keeper.removed();
}
}  // namespace monoslam
