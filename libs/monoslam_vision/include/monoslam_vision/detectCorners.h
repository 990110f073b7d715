// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "monoslam_vision/PreparedImage.h"
#include "monoslam_vision/export.h"

namespace monoslam
{
/** Where new corners may be and what makes one good enough. */
struct DetectionOptions
{
    int gridColumns = 8;
    int gridRows = 6;
    int maxPerCell = 3;              ///< landmarks and new corners together
    double minDistance_px = 15.0;    ///< to every taken pixel and between new corners
    double border_px = 10.0;         ///< of the image
    double quality = 0.03;           ///< least response relative to the strongest one
    double minResponse = 2e-5;       ///< least smaller eigenvalue, absolute (grey range 1)
    double maxSelfSimilarity = 0.9;  ///< ZNCC with its own surroundings; 1 = off
    double similarityRadius_px = 12.0;
    int half_px = 6;    ///< of the patch
    int maxCells = 12;  ///< looked into per call once some landmarks exist
};

struct Corner
{
    Eigen::Vector2d uv_px;  ///< integer pixel
    double response = 0.0;  ///< smaller eigenvalue of the structure tensor
};

/** Best corners of the emptiest cells first; cells of equal count in seeded random order.
 *
 * \param taken      pixels of landmarks and candidates
 * \param strongest  largest response met so far; raised here, input of the relative test */
[[nodiscard]] MONOSLAM_VISION_EXPORT std::vector<Corner> detectCorners(
    const PreparedImage& image, const std::vector<Eigen::Vector2d>& taken, int wanted,
    const DetectionOptions& options, double& strongest, std::mt19937& rng);
}  // namespace monoslam
