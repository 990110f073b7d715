// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "monoslam_filter/Belief.h"
#include "monoslam_filter/editBelief.h"
#include "monoslam_models/triangulate.h"
#include "monoslam_vision/Patch.h"
#include "monoslam_vision/alignPatch.h"
#include "monoslam_vision/export.h"
#include "monoslam_vision/predictWarp.h"

namespace monoslam
{
/** A corner followed in the image, outside the filter, until its parallax gives a depth. */
struct TrackedCorner
{
    LandmarkId id = -1;
    Appearance born;
    FirstView first;
    Eigen::Vector2d uv_px;  ///< where it was seen last
    double rho = 1.0;       ///< best guess of 1 / distance from the first camera
    double sigma_rho = 0.5;
    int seen = 1;
    int missed = 0;
    int missedInRow = 0;
    long bornFrame = 0;
    std::optional<Triangulation> triangulation;  ///< of this frame, if seen in it
};

struct CornerTrackerOptions
{
    double minScore = 0.8;
    int half_px = 6;
    double minHalfWidth_px = 3.0;  ///< of the band along the ray
    double maxReach_px = 40.0;     ///< half length of the band
    int maxMissedInRow = 3;
    int maxAge_frames = 300;
    double uniqueness = 0.05;  ///< the best peak beats one 5 px away by this much
    WarpLimits warp;
    AlignOptions align;
};

/** Follows one corner into the current image along its projected ray (algorithms 3.4).
 *
 * The first pose is the clone's current estimate, or the stored one in paper mode.
 * \return the corner with its counts, pixel and triangulation brought up to date; nothing when it
 * should be given up */
[[nodiscard]] MONOSLAM_VISION_EXPORT std::optional<TrackedCorner> trackCorner(
    TrackedCorner corner, const Belief& belief, const Camera& camera, const PreparedImage& image,
    long frame, const CornerTrackerOptions& options);
}  // namespace monoslam
