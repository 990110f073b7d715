// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "PairMatrix.h"
#include "RemovalBound.h"
#include "monoslam_association/jointCompatibility.h"

namespace monoslam
{
/** A removed set and what is known of re-inserting its pairs (hohct-fast I2).
 *
 *      Sig = Lam_RR^-1,  nu = Sig gt_R,  W = -Sig Lam_RK
 *
 * nu is the innovation of the removed pairs given those kept, Sig its covariance, W the regression
 * of the removed pairs' innovations on those of the pairs kept. Vectors over the k pairs kept have
 * one component of all pairs first, then the other. */
struct ReinsertionReference
{
    std::vector<Eigen::Index> removed;  ///< farthest from what is kept first
    std::vector<Eigen::Index> kept;
    Eigen::MatrixXd Sig;           ///< 2r x 2r
    Eigen::VectorXd nu;            ///< 2r
    Eigen::MatrixXd Wt;            ///< W', 2k x 2r
    PairMatrix Lam;                ///< of the pairs kept, k
    PairVector gt;                 ///< of them
    double d2 = 0.0;               ///< of them
    Eigen::ArrayX3d Sig_diagonal;  ///< (0, 0), (1, 0), (1, 1) of the inverses of Lam's blocks
    RemovalBound bound;            ///< of them, for up to r removals

    /** O(m^2 r). \param whole  no pair removed from it */
    ReinsertionReference(const DowndatingD2& whole, std::vector<Eigen::Index> removedPairs);
};
}  // namespace monoslam
