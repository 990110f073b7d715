// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "LandmarkRecord.h"
#include "monoslam_association/Associator.h"
#include "monoslam_models/Camera.h"
#include "monoslam_slam/SearchOptions.h"
#include "monoslam_vision/CornerTracker.h"
#include "monoslam_vision/searchPatch.h"

namespace monoslam
{
/** 3-D point of a landmark; a point far along the ray where rho is not clearly positive. */
[[nodiscard]] Eigen::Vector3d landmarkPoint(const Belief& belief, const LandmarkSlot& slot);

[[nodiscard]] CornerTrackerOptions trackerOptions(const SearchOptions& search);

/** What one candidate's alignment told of its landmark's surface. */
struct SeenSlope
{
    Eigen::Vector2d z;
    SlopeEstimate slope;
};

/** Active search in one frame: expected patches are made once per landmark from one belief. */
class LandmarkFinder
{
   public:
    LandmarkFinder(const Camera& camera, const PreparedImage& image, const SearchOptions& options,
                   const LandmarkRecords& records, const Belief& expected)
        : camera_(camera), image_(image), options_(options), records_(records), expected_(expected)
    {
    }

    [[nodiscard]] SearchResult search(const SearchRegion& region);

    /** Of every candidate that has been found so far. */
    [[nodiscard]] const std::map<LandmarkId, std::vector<SeenSlope>>& slopes() const
    {
        return slopes_;
    }

   private:
    [[nodiscard]] const std::optional<Patch>& patchOf(LandmarkId id);

    const Camera& camera_;
    const PreparedImage& image_;
    const SearchOptions& options_;
    const LandmarkRecords& records_;
    const Belief& expected_;
    std::map<LandmarkId, std::optional<Patch>> patches_;
    std::map<LandmarkId, std::vector<SeenSlope>> slopes_;
};
}  // namespace monoslam
