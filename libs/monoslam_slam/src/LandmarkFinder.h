// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "LandmarkRecord.h"
#include "monoslam_association/Associator.h"
#include "monoslam_models/Camera.h"
#include "monoslam_slam/SearchOptions.h"
#include "monoslam_vision/CornerTracker.h"
#include "monoslam_vision/alignPatch.h"
#include "monoslam_vision/searchPatch.h"

namespace monoslam
{
/** 3-D point of a landmark; a point far along the ray where rho is not clearly positive.
 *  \param y  its six or three numbers */
[[nodiscard]] Eigen::Vector3d landmarkPoint(LandmarkKind kind,
                                            const Eigen::Ref<const Eigen::VectorXd>& y);
[[nodiscard]] Eigen::Vector3d landmarkPoint(const Belief& belief, const LandmarkSlot& slot);

[[nodiscard]] CornerTrackerOptions trackerOptions(const SearchOptions& search);

/** Active search in one frame: expected patches are made once per landmark from one belief, and a
 *  peak is aligned once. search() may be called from several threads at once. */
class LandmarkFinder
{
   public:
    LandmarkFinder(const Camera& camera, const PreparedImage& image, const SearchOptions& options,
                   const LandmarkRecords& records, const Belief& expected)
        : camera_(camera), image_(image), options_(options), records_(records), expected_(expected)
    {
    }

    [[nodiscard]] SearchResult search(const SearchRegion& region);

    /** What the alignment of a candidate told of its landmark's surface; nothing if no candidate of
     *  that landmark was found at z. */
    [[nodiscard]] std::optional<SlopeEstimate> slopeSeen(LandmarkId id,
                                                         const Eigen::Vector2d& z) const;

   private:
    /** What is known of a landmark in this frame. */
    struct Expected
    {
        std::mutex mutex;
        bool sampled = false;
        std::optional<Patch> patch;
        std::map<std::pair<int, int>, std::optional<AlignedPatch>> aligned;  ///< by peak
    };

    [[nodiscard]] Expected& expectedOf(LandmarkId id);
    [[nodiscard]] const std::optional<Patch>& patchOf(Expected& landmark, LandmarkId id) const;
    [[nodiscard]] std::optional<AlignedPatch> align(Expected& landmark, LandmarkId id,
                                                    const Eigen::Vector2d& peak) const;

    const Camera& camera_;
    const PreparedImage& image_;
    const SearchOptions& options_;
    const LandmarkRecords& records_;
    const Belief& expected_;
    std::mutex mutex_;  ///< of the map; its entries have their own
    std::map<LandmarkId, Expected> landmarks_;
};
}  // namespace monoslam
