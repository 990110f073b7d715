// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "monoslam_vision/Patch.h"
#include "monoslam_vision/PreparedImage.h"
#include "monoslam_vision/export.h"

namespace monoslam
{
/** An integer pixel where the patch correlates best. */
struct CorrelationPeak
{
    Eigen::Vector2d uv_px;
    double score = 0.0;  ///< ZNCC
};

struct PatchSearch
{
    std::vector<CorrelationPeak> peaks;  ///< best first
    long pixels = 0;                     ///< positions correlated
};

/** The ellipse to search and what counts as found. */
struct PatchSearchRegion
{
    Eigen::Vector2d centre_px;
    Eigen::Matrix2d S;      ///< [px^2]
    double gate = 9.21;     ///< (p - centre)' S^-1 (p - centre) < gate
    double minScore = 0.8;  ///< ZNCC
    int maxPeaks = 1;
    double peakDistance_px = 3;  ///< between two peaks
};

/** Local maxima of the zero-mean normalised cross correlation inside an ellipse.
 *
 *     ZNCC = sum (T - mean T) I / (|T - mean T| sqrt(sum I^2 - (sum I)^2 / n))
 *
 * The sums of I come from integral images, so that a position costs one product sum. */
[[nodiscard]] MONOSLAM_VISION_EXPORT PatchSearch searchPatch(const PreparedImage& image,
                                                             const Patch& patch,
                                                             const PatchSearchRegion& region);

/** ZNCC of the patch centred on one integer pixel; -1 outside the image. */
[[nodiscard]] MONOSLAM_VISION_EXPORT double correlate(const PreparedImage& image,
                                                      const Patch& patch, int u, int v);
}  // namespace monoslam
