// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "monoslam_filter/export.h"
#include "monoslam_models/ConstantVelocity.h"
#include "monoslam_models/projectLandmark.h"

namespace monoslam
{
using LandmarkId = std::int64_t;
using CloneId = std::int64_t;

/** Where a landmark stands in the state vector. */
struct LandmarkSlot
{
    LandmarkId id = -1;
    LandmarkKind kind = LandmarkKind::InverseDepth;
    Eigen::Index offset = 0;

    [[nodiscard]] Eigen::Index size() const { return landmarkSize(kind); }
};

/** Where a copy of an earlier camera pose (r_wc, q_wc) stands in the state vector. */
struct CloneSlot
{
    CloneId id = -1;
    Eigen::Index offset = 0;
};

/** Gaussian belief N(x, P) over camera, pose clones and landmarks, and the layout of its state.
 *
 * x = [x_v (13) | clones (7 each) and landmarks (6 or 3 each), in any order]; P is symmetric and
 * both halves are stored. P has a null direction along each quaternion: never invert P. Only the
 * functions of editBelief.h change the layout. */
struct MONOSLAM_FILTER_EXPORT Belief
{
    Eigen::VectorXd x;
    Eigen::MatrixXd P;
    std::vector<LandmarkSlot> landmarks;
    std::vector<CloneSlot> clones;

    /** A camera alone. \param P_v 13 x 13 covariance of x_v */
    static Belief ofCamera(const Vector13d& x_v, const Matrix13d& P_v);

    [[nodiscard]] Eigen::Index size() const { return x.size(); }
    [[nodiscard]] Vector13d camera() const { return x.head<camera_state::kSize>(); }
    [[nodiscard]] Vector7d pose() const { return x.head<camera_state::kPoseSize>(); }
    [[nodiscard]] Vector7d clonePose(const CloneSlot& slot) const
    {
        return x.segment<camera_state::kPoseSize>(slot.offset);
    }

    /** Index in landmarks, or -1. */
    [[nodiscard]] Eigen::Index find(LandmarkId id) const;
    [[nodiscard]] const CloneSlot* findClone(CloneId id) const;

    /** \throw std::logic_error if sizes, offsets, symmetry or quaternion norms disagree. */
    void checkInvariant() const;
};

/** One hypothesis about the past and its weight; all strategies but MHDA carry exactly one. */
struct WeightedBelief
{
    Belief belief;
    double logWeight = 0.0;
    /** Frames since it and each belief of the mixture were one; empty if they always were. */
    std::vector<long> separation = {};
};
using Mixture = std::vector<WeightedBelief>;

/** The belief of largest weight. \throw std::logic_error on an empty mixture */
[[nodiscard]] MONOSLAM_FILTER_EXPORT const Belief& best(const Mixture& mixture);
[[nodiscard]] MONOSLAM_FILTER_EXPORT Belief& best(Mixture& mixture);
/** Its index, the first of several. */
[[nodiscard]] MONOSLAM_FILTER_EXPORT std::size_t bestIndex(const Mixture& mixture);
}  // namespace monoslam
