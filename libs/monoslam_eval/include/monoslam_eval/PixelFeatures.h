// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "monoslam_association/Associator.h"
#include "monoslam_eval/export.h"

namespace monoslam
{
/** How much a feature looks like one landmark. */
struct Resemblance
{
    LandmarkId landmark = -1;
    double score = 1.0;  ///< ZNCC in [-1, 1]
};

/** PixelFeature::truth of a feature that is the image of no landmark. */
inline constexpr LandmarkId kOfNoLandmark = -1;
/** PixelFeature::truth of a feature of which nobody knows. */
inline constexpr LandmarkId kUnknownTruth = -2;

/** A place in the image of which there is no image, only a pixel. */
struct PixelFeature
{
    std::int64_t id = -1;  ///< within its frame; tells nothing about landmarks
    Eigen::Vector2d z = Eigen::Vector2d::Zero();      ///< [px]
    Eigen::Matrix2d R = Eigen::Matrix2d::Identity();  ///< noise of z [px^2]
    std::vector<Resemblance> resembles;               ///< landmarks whose search finds it
    LandmarkId truth =
        kUnknownTruth;  ///< the landmark that it is the image of, or one of the above
};

/** All features of one frame. */
struct PixelFrame
{
    double t_s = 0.0;
    std::vector<PixelFeature> features;
};

/** What a strategy may ask of the frame: a search finds the features inside its ellipse that
 *  resemble its landmark, best scores first. The camera must outlive the view. */
[[nodiscard]] MONOSLAM_EVAL_EXPORT FrameView viewOf(const PixelFrame& frame, const Camera& camera,
                                                    const VisibilityOptions& visibility);
}  // namespace monoslam
