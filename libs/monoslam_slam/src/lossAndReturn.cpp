// SPDX-License-Identifier: BSD-3-Clause
// What a run does when it has lost track: it begins a new map, and looks for the way back into the old one.
#include <algorithm>

#include "MonoSlamImpl.h"
#include "monoslam_association/fateCounts.h"

namespace monoslam
{
/** Keeps what a lost map's landmarks looked like when they were last seen. */
void MonoSlam::Impl::noteView(const FrameContext& context, const FrameReport& report)
{
    if (options.map.relocalize_every == 0 || report.matched < options.map.min_matched) return;
    lastView.image = context.image;
    lastView.pixels.clear();
    for (const Association& association : report.associations)
        if (association.fate == Fate::Matched)
            lastView.pixels.emplace_back(association.id, association.z);
}

/** The map that is given up, unless it is not to be looked for. */
void MonoSlam::Impl::remember(double rho0)
{
    if (options.map.relocalize_every == 0) return;
    keeper.keepOnly(best(mixture));
    LostMap map{best(mixture), keeper.records(), std::nullopt, origin, rho0, judge.restarted(), {}};
    if (window) map.window.emplace(std::move(*window));
    lost.keep(std::move(map), lastView);
    looksDue = 1 + options.map.relocalize_every;
}

/** A new map around the last pose, in the old map's median depth, when nothing matches any more. */
void MonoSlam::Impl::restart(const FrameContext& context)
{
    const double rho0 = keeper.medianRho(best(mixture));
    remember(rho0);
    Belief& old = best(mixture);
    Eigen::Matrix<double, 7, 7> P = old.P.topLeftCorner<7, 7>();
    if (origin) P += worldCovariance(*origin, old.pose());
    origin = WorldOrigin{old.pose(), P};
    StartBelief again = restartBelief(old, rho0, options.initialization);
    mixture = {{std::move(again.belief), 0.0}};
    keeper.keepOnly(best(mixture));
    mixture = keeper.addFirst(std::move(mixture), context, again.rho0, again.sigma_rho);
    if (!options.start.parallax_deg.empty()) window.emplace(options.start, camera, false);
    judge.noteRestart();
}

/** Whether a frame looks like a map from where it was placed in it, to those who track it. */
bool MonoSlam::Impl::verify(const FrameContext& context, const LostMap& map, const Belief& placed)
{
    SearchOptions search = options.search;
    search.sigma_floor_px = noise.floor_px();
    LandmarkFinder finder(camera, *context.image, search, map.records, placed);
    const Correction correction = associator->correct({{placed, 0.0}}, viewOf(finder), rng);
    const FateCounts counts = countFates(correction.associations);
    return explainsFrame(counts) && counts.matched >= 2L * options.map.min_matched;
}

/** Looks for what was lost: in the frame of the loss and the next few, which still see most of it, in every
 *  frame while there is nothing to lose, and now and then while a new map is tracked. True if the mixture is the lost map's, with the camera in it. */
bool MonoSlam::Impl::returnToLostMap(const FrameContext& context)
{
    if (lost.empty() || !judge.restarted()) return false;
    const bool regular = ++unlooked >= options.map.relocalize_every;
    if (!judge.poor() && looksDue == 0 && !regular) return false;
    looksDue = std::max(0, looksDue - 1);
    unlooked = 0;
    for (const MapSighting& sighting : lost.find(*context.image, camera, judge.poor()))
    {
        const LostMap& map = lost.at(sighting.map);
        const Belief resting = restartBelief(map.belief, map.rho0, options.initialization).belief;
        Belief placed = placeInMap(map, sighting, camera, resting, engine);
        if (!verify(context, map, placed)) continue;
        enter(lost.takeOut(sighting.map), std::move(placed));
        return true;
    }
    return false;
}

/** \param returned  whether the mixture has just been placed in a lost map, at this frame */
void MonoSlam::Impl::trackAndJudge(const FrameContext& context, double dt_s, bool returned,
                                   FrameReport& report, ThreadClock& clock)
{
    if (returned) report.remark = "back in the map that was lost";
    track(context, dt_s, report, clock);
    judge.assess(report, noise.sigma_px(), startUnexplained(), afterGap);
}

/** Begins a new map, unless the frame shows an old one after all: then the frame is tracked there. */
void MonoSlam::Impl::lose(const FrameContext& context, FrameReport& report, ThreadClock& clock)
{
    restart(context);
    if (!returnToLostMap(context)) return;
    StageTimes before = report.times;
    before.prepare_ms += clock.lap_ms();
    trackAndJudge(context, 0.0, true, report, clock);
    report.times += before;
}

/** Goes on in a map that was lost. */
void MonoSlam::Impl::enter(LostMap map, Belief placed)
{
    mixture = {{std::move(placed), 0.0}};
    keeper.takeOver(std::move(map.records));
    origin = map.origin;
    window.reset();
    if (map.window) window.emplace(std::move(*map.window));
    keeper.setStarting(window && window->open());
    judge.noteReturn(map.guessed);
}
}  // namespace monoslam
