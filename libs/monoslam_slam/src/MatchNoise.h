// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_slam/SearchOptions.h"

namespace monoslam
{
/** Lets the noise of a match follow the residuals: what calibration, shutter and blur add to a match
 *  differs from camera to camera and is not in the alignment's own covariance. */
class MatchNoise
{
   public:
    explicit MatchNoise(const SearchOptions& options);

    /** Takes in the squared residuals of one frame [px^2]; too few do not count. */
    void adapt(std::vector<double> squares);

    /** What the residuals say so far; 0 before the first frame. */
    [[nodiscard]] double sigma_px() const;

    /** What a match has at least. */
    [[nodiscard]] double floor_px() const;

   private:
    double least_;  ///< of the variance [px^2]
    double most_;
    double sigma2_ = 0.0;  ///< of a match [px^2]
};
}  // namespace monoslam
