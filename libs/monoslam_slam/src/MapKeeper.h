// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <random>
#include <vector>

#include "LandmarkFinder.h"
#include "LandmarkRecord.h"
#include "monoslam_association/Associator.h"
#include "monoslam_models/Camera.h"
#include "monoslam_slam/MetricStart.h"
#include "monoslam_slam/MonoSlamOptions.h"
#include "monoslam_vision/CornerTracker.h"

namespace monoslam
{
/** The frame that the map is revised with. */
struct FrameContext
{
    std::shared_ptr<const PreparedImage> image;
    long index = 0;
};

/** Decides which landmarks enter, change form and leave; remembers how each one looked and fared. */
class MapKeeper
{
   public:
    /** Keeps a reference to the camera, whose readout may change. */
    MapKeeper(const MonoSlamOptions& options, const Camera& camera, unsigned seed);
    MapKeeper(const MonoSlamOptions& options, Camera&& camera, unsigned seed) = delete;

    /** Known points of the metric target become landmarks that are never removed while they match. */
    [[nodiscard]] Mixture addKnownPoints(Mixture mixture, const MetricPose& target,
                                         const FrameContext& frame);

    /** First landmarks, undelayed, around the inverse depth rho0. */
    [[nodiscard]] Mixture addFirst(Mixture mixture, const FrameContext& frame, double rho0,
                                   double sigma_rho);

    /** After an update: counts fates, removes, converts, tracks candidates, adds. Each belief of
     *  the mixture removes by its own track records; all get the same new landmarks, where the
     *  belief of largest weight sees place for them.
     *  \param correction  its mixture has been moved to \p mixture */
    [[nodiscard]] Mixture revise(Mixture mixture, const Correction& correction,
                                 const FrameContext& frame);

    /** Each landmark's own noise follows its residuals: corners on edges are worse than others. */
    void noteResiduals(const Belief& belief, const std::vector<Association>& associations);

    /** Learns the slope of the surfaces from the matches among the candidates seen. */
    void learnSlopes(const std::vector<Association>& associations, const LandmarkFinder& finder);

    /** Goes on with one belief, made of the one of largest weight in the last revision: forgets
     *  every landmark that is not in it, and all candidates. */
    void keepOnly(const Belief& belief);

    /** Goes on with a belief of before and what was known of its landmarks then. */
    void takeOver(LandmarkRecords records);

    /** A map estimated anew knows what was seen often: the rest of what was matched in this frame
     *  enters it again, undelayed, where it was seen, unless it is distrusted. Without it a camera
     *  that turns away from its first view would face an empty part of the map. */
    [[nodiscard]] Belief addAgain(Belief belief, const std::vector<Association>& associations,
                                  const std::vector<LandmarkId>& distrusted) const;

    /** Median inverse distance of the landmarks that have been seen often, else rho0. */
    [[nodiscard]] double medianRho(const Belief& belief) const { return priorNow(belief).rho0; }

    /** While starting, landmarks enter undelayed only. */
    void setStarting(bool starting) { starting_ = starting; }

    [[nodiscard]] const LandmarkRecords& records() const { return records_; }
    [[nodiscard]] int candidates() const { return static_cast<int>(corners_.size()); }
    [[nodiscard]] int added() const { return added_; }
    [[nodiscard]] int removed() const { return removed_; }

   private:
    void noteFates(const Mixture& mixture, const Correction& correction, long frame);
    [[nodiscard]] bool isBad(const TrackRecord& record, long frame) const;
    [[nodiscard]] std::vector<LandmarkId> badOnes(Belief& belief, const TrackRecords& tracks,
                                                  long frame) const;
    [[nodiscard]] std::vector<LandmarkId> leastUseful(const TrackRecords& tracks,
                                                      std::size_t count) const;
    void remove(Mixture& mixture, std::size_t belief, const std::vector<LandmarkId>& ids);
    void enter(LandmarkId id, LandmarkRecord record, const Mixture& mixture);
    /** The candidate in every belief, triangulated from the poses that each of them knows. */
    [[nodiscard]] Mixture addTriangulatedTo(Mixture mixture, const TrackedCorner& corner,
                                            double sigma_px) const;
    [[nodiscard]] Mixture removeBad(Mixture mixture, long frame);
    [[nodiscard]] Mixture boundState(Mixture mixture);
    [[nodiscard]] Mixture convert(Mixture mixture) const;
    [[nodiscard]] Mixture promoteCandidates(Mixture mixture, const FrameContext& frame);
    [[nodiscard]] bool mayEnter(const TrackedCorner& corner) const;
    [[nodiscard]] Mixture addNew(Mixture mixture, const FrameContext& frame);
    [[nodiscard]] Mixture addUndelayedAt(Mixture mixture,
                                         const std::vector<Eigen::Vector2d>& pixels,
                                         const UndelayedPrior& prior, const FrameContext& frame);
    [[nodiscard]] Mixture startCandidates(Mixture mixture,
                                          const std::vector<Eigen::Vector2d>& pixels,
                                          const FrameContext& frame);
    /** The present pose as a clone, in the place of the oldest one if there are too many. */
    [[nodiscard]] Mixture clonePose(Mixture mixture, CloneId clone);
    [[nodiscard]] Mixture dropUnusedClones(Mixture mixture) const;
    [[nodiscard]] std::vector<Eigen::Vector2d> takenPixels(const Belief& belief) const;
    [[nodiscard]] UndelayedPrior priorNow(const Belief& belief) const;

    MonoSlamOptions options_;
    const Camera& camera_;
    std::mt19937 rng_;
    LandmarkRecords records_;
    std::vector<TrackRecords> tracks_ =
        std::vector<TrackRecords>(1);  ///< of each belief of the mixture, at first one
    std::size_t best_ = 0;             ///< of them, the one that records_ tell of
    std::vector<TrackedCorner> corners_;
    LandmarkId nextId_ = 0;
    CloneId nextClone_ = 0;
    double strongest_ = 0.0;
    int matchedNow_ = 0;
    int added_ = 0;
    int removed_ = 0;
    bool starting_ = false;
};
}  // namespace monoslam
