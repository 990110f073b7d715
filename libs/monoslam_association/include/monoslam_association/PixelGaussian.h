// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "monoslam_association/export.h"
#include "monoslam_filter/predictMeasurements.h"

namespace monoslam
{
/** Gaussian over the noise-free pixels of the m rows of a Prediction, conditioned on measurements. */
class MONOSLAM_ASSOCIATION_EXPORT PixelGaussian
{
   public:
    virtual ~PixelGaussian() = default;
    PixelGaussian& operator=(const PixelGaussian&) = delete;
    [[nodiscard]] virtual std::unique_ptr<PixelGaussian> clone() const = 0;

    [[nodiscard]] virtual Eigen::Vector2d mean(Eigen::Index row) const = 0;
    /** Without R. */
    [[nodiscard]] virtual Eigen::Matrix2d covariance(Eigen::Index row) const = 0;
    /** On z = pixel of the row + noise of covariance R. */
    virtual void condition(Eigen::Index row, const Eigen::Vector2d& z,
                           const Eigen::Matrix2d& R) = 0;

   protected:
    PixelGaussian() = default;
    PixelGaussian(const PixelGaussian&) = default;
};

/** All correlations:  Sig - Sig_:f (Sig_ff + R)^-1 Sig_f: = Sig_0 - W W', a pair of columns of W per
 *  measurement; O(m k) for the k-th. \param prediction  must outlive it */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT std::unique_ptr<PixelGaussian> densePixels(
    const Prediction& prediction);

/** The Chow-Liu tree: the maximum spanning tree of pairwise mutual information, and every pair of
 *  its neighbours with their exact joint covariance. A measurement is passed on along the edges,
 *
 *      B = Sig_ji Sig_ii^-1,   mean_j += B d_i,   Sig_jj += B (Sig_ii' - Sig_ii) B',   Sig_ji = B Sig_ii'
 *
 * O(m). \see Handa, Chli, Strasdat, Davison, "Scalable active matching", CVPR 2010 */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT std::unique_ptr<PixelGaussian> treePixels(
    const Prediction& prediction);

/** Parent of every row in that tree, -1 for the root and for rows that correlate with none. Edges are
 *  weighed by 1/2 log2(|S_ii| |S_jj| / |S_(ij)|), S with R. Prim, O(m^2). */
[[nodiscard]] MONOSLAM_ASSOCIATION_EXPORT std::vector<Eigen::Index> chowLiuParents(
    const Prediction& prediction);
}  // namespace monoslam
