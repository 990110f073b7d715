// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "LandmarkRecord.h"
#include "StartWindow.h"
#include "monoslam_filter/Belief.h"
#include "monoslam_filter/FilterEngine.h"
#include "monoslam_models/Camera.h"
#include "monoslam_vision/describeCorners.h"
#include "refinePose.h"
#include "startBelief.h"

namespace monoslam
{
/** What the last frame that was tracked well saw of the map. */
struct LastView
{
    std::shared_ptr<const PreparedImage> image;
    std::vector<std::pair<LandmarkId, Eigen::Vector2d>> pixels;
};

/** A map that the camera lost track of, as it was then. */
struct LostMap
{
    Belief belief;
    LandmarkRecords records;
    std::optional<StartWindow> window;
    std::optional<WorldOrigin> origin;
    double rho0 = 0.0;           ///< median inverse depth of what the camera saw [1/m]
    bool guessed = false;        ///< its own place and scale are guesses: it was begun after a loss
    DescribedCorners described;  ///< its landmarks, by their index in the belief
};

/** Where the camera stands in a lost map. */
struct MapSighting
{
    std::size_t map = 0;
    CameraPose pose;
    std::vector<LandmarkId> ids;         ///< of the landmarks that say so ...
    std::vector<Eigen::Vector2d> uv_px;  ///< ... and where they are seen
};

/** The maps that were lost, the first one first, and how to find the way back into them: by what their
 *  landmarks look like (describeCorners) and the pose that most matches agree on (OpenCV's P3P and
 *  RANSAC, whose draws are the same every time). */
class LostMaps
{
   public:
    /** Keeps a map with enough landmarks of known depth; of many, the first one and the latest. */
    void keep(LostMap map, const LastView& last);

    /** Forgets all that tells less than the map that was found. */
    LostMap takeOut(std::size_t map);

    /** \param guessed  whether maps whose place is a guess are of interest, too */
    [[nodiscard]] std::vector<MapSighting> find(const PreparedImage& image, const Camera& camera,
                                                bool guessed) const;

    [[nodiscard]] const LostMap& at(std::size_t map) const { return *maps_.at(map); }
    [[nodiscard]] bool empty() const { return maps_.empty(); }

   private:
    std::vector<std::unique_ptr<LostMap>> maps_;
};

/** The belief of a lost map with the camera where it was seen: an EKF update, linearised at that pose, of
 *  a camera that knows nothing of where it is. Pose and map are then correlated as they should be.
 *  \param resting  a camera alone: its velocities and their covariance are taken */
[[nodiscard]] Belief placeInMap(const LostMap& map, const MapSighting& sighting,
                                const Camera& camera, const Belief& resting,
                                const FilterEngine& engine);
}  // namespace monoslam
