// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <vector>

#include "monoslam_filter/ekf.h"

namespace monoslam
{
/** Pairs that suffice to fix the six numbers of a camera pose. */
inline constexpr std::size_t kPoseFixingPairs = 3;

/** Variance that covers what a linear prediction misses [px^2]. */
inline constexpr double kLinearizationVariance_px2 = 0.5;

/** Measurements of other landmarks given an accepted set a, in measurement space.
 *
 *      S_aa = L L',  Y = L^-1 HPHt_aj:   shift = Y' L^-1 nu_a,   HPHt_j|a = HPHt_jj - Y'Y
 */
class ConditionalPrediction
{
   public:
    ConditionalPrediction(const Prediction& prediction,
                          const std::vector<PixelMeasurement>& accepted);

    struct Row
    {
        Eigen::Vector2d shift;  ///< of the predicted pixel [px]
        Eigen::Matrix2d HPHt;   ///< without R [px^2]
    };
    /** False if S_aa is not positive definite. */
    [[nodiscard]] bool valid() const { return valid_; }
    [[nodiscard]] double d2() const { return e_.squaredNorm(); }
    [[nodiscard]] Row row(Eigen::Index j) const;

   private:
    const Prediction& prediction_;
    std::vector<Eigen::Index> rows_;
    Eigen::LLT<Eigen::MatrixXd> llt_;
    Eigen::VectorXd e_;
    bool valid_ = false;
};
}  // namespace monoslam
