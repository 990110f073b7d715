// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "monoslam_association/CandidateLikelihood.h"
#include "monoslam_association/PixelGaussian.h"

namespace monoslam
{
/** Options shared by Active Matching and its approximations. */
struct MatchingOptions
{
    ClutterOptions clutter;
    double prune = 1e-3;     ///< least weight of a Gaussian relative to the heaviest
    int max_gaussians = 12;  ///< K_max
    double stop_bits = 0.1;  ///< the search ends when no measurement tells as much

    /** Reads the keys above; the caller rejects unknown ones. */
    static MatchingOptions from(ConfigSection& section);
};

/** A frame to be matched, and what is recorded of it. */
struct MatchingFrame
{
    const Prediction& prediction;
    const FrameView& view;
    std::vector<Eigen::Index> rows;          ///< that may be searched
    int max_measured = 60;                   ///< of them
    std::vector<Association>& associations;  ///< one per row of the prediction
    AssociationCounters& counters;
};

/** Active Matching: a mixture of Gaussians over all predicted pixels, grown by one searched ellipse
 *  after the other.
 *
 * Of all Gaussians k and rows f not measured in k the pair of most expected information per area
 * A_kf is searched, with q_j the mass of Gaussian j's prediction of f inside that ellipse:
 *
 *      Mc = lam_k P_D 1/2 log2(|S_f^k| / |R|)
 *      Md = H(lam) - p_1 H(lam_j P_D q_j / p_1) - (1 - p_1) H(lam_j (1 - P_D q_j) / (1 - p_1))
 *
 * Every Gaussian that the ellipse holds more than half of splits: given each pixel found, with weight
 * lam_j P_D N / beta, and given none, with lam_j (1 - P_D q_j); the row is then measured in it. The
 * others wait for an ellipse of their own, so that each is weighed once by every row. Light ones are
 * dropped.
 * \return the pixels of the heaviest Gaussian
 * \see Chli, Davison, "Active matching for visual tracking", Robotics and Autonomous Systems 2009 */
[[nodiscard]] std::vector<PixelMeasurement> matchActively(std::unique_ptr<PixelGaussian> prior,
                                                          const MatchingOptions& options,
                                                          const MatchingFrame& frame);
}  // namespace monoslam
