// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "monoslam_vision/Patch.h"

namespace monoslam
{
constexpr Eigen::Index kMostPatchPixels = 31 * 31;

/** Image values at the pixels of a patch, row by row. */
using PatchSamples = Eigen::Matrix<float, Eigen::Dynamic, 1, 0, kMostPatchPixels, 1>;

/** Linear regression of image samples on a patch's derivatives, with what is known of the slope
 *  beforehand: samples = A x,  x = (g t, g ds, g, offset),  A = [T_x T_y grad T . E_k d, T, 1]. */
class PatchRegression
{
   public:
    static constexpr Eigen::Index kSlope = 2;
    static constexpr Eigen::Index kGain = 4;
    static constexpr Eigen::Index kUnknowns = 6;
    using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;

    explicit PatchRegression(const Patch& patch);

    /** Least squares of the samples and of the slope's prior.
     *  \param slope where the regression is linearised
     *  \param variance of a pixel's noise over the squared gain [grey levels^2] */
    [[nodiscard]] Unknowns fit(const PatchSamples& samples, const Eigen::Vector2d& slope,
                               double gain, double variance);

    /** Of the residuals [grey levels^2]. */
    [[nodiscard]] double variance(const PatchSamples& samples, const Unknowns& x) const;

    /** Covariance of the shift by the last fit over the noise's variance [px^2]. */
    [[nodiscard]] Eigen::Matrix2d shiftCovariance() const;

    /** Information of the pixels alone on the slope times the noise's variance; the other unknowns
     *  are eliminated. */
    [[nodiscard]] Eigen::Matrix2d slopeInformation() const;

   private:
    using Matrix6d = Eigen::Matrix<double, kUnknowns, kUnknowns>;

    const Patch& patch_;
    Eigen::Matrix<float, Eigen::Dynamic, kUnknowns, 0, kMostPatchPixels, kUnknowns> A_;
    Matrix6d pixels_;  ///< A' A
    Eigen::LDLT<Matrix6d> ldlt_;
};
}  // namespace monoslam
