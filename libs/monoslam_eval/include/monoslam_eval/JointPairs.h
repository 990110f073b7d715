// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "monoslam_eval/export.h"

namespace monoslam
{
/** Where the joint covariance of drawn pairs comes from. */
enum class CovarianceKind
{
    Independent,  ///< uncertain camera pose, landmarks known independently of each other
    Filter,       ///< the map of a filter that has run for some frames: all is correlated
};

/** How wrong pairs are wrong; in their own gates they all are. */
enum class OutlierKind
{
    Uniform,  ///< each anywhere in its gate
    Cluster,  ///< image neighbours, all off by one and the same offset of 4 to 20 px
};

/** The joint prediction of some landmarks' pixels. */
struct JointPrior
{
    Eigen::MatrixXd S;                    ///< innovation covariance [px^2]
    std::vector<Eigen::Vector2d> pixels;  ///< predicted
};

/** A camera of 640 x 480 px and 400 px focal length sees landmarks 0.5 to 5 m away; sigma = 1 px.
 *
 * Independent: the pose is uncertain by 2 to 5 cm and 0.7 to 1.4 degrees, correlated; a landmark by
 * 2 to 15 % of its distance along the ray of an earlier view. Filter: eight frames of the EKF with
 * that process noise, a landmark born in any of them with a depth uncertain by 30 %. */
[[nodiscard]] MONOSLAM_EVAL_EXPORT JointPrior drawJointPrior(Eigen::Index landmarks,
                                                             CovarianceKind kind,
                                                             std::mt19937& rng);

/** Pairs of landmark and measurement of which the truth is known. */
struct JointPairs
{
    Eigen::MatrixXd S;        ///< 2m x 2m [px^2]
    Eigen::VectorXd nu;       ///< 2m [px]
    std::vector<char> wrong;  ///< m
};

/** What is drawn from a prior. */
struct JointPairsOptions
{
    Eigen::Index pairs = 0;
    Eigen::Index wrong = 0;
    OutlierKind outliers = OutlierKind::Uniform;
    double gateProbability = 0.95;  ///< each pair lies in its own gate
};

/** Innovations from N(0, S), of which those outside their gates are never seen; then some of the
 *  pairs seen become wrong. \param prior  has some more landmarks than pairs are asked for
 *  \throw std::runtime_error if no such pairs are found */
[[nodiscard]] MONOSLAM_EVAL_EXPORT JointPairs drawJointPairs(const JointPrior& prior,
                                                             const JointPairsOptions& options,
                                                             std::mt19937& rng);

/** Landmarks of which \p pairs are seen in most draws. */
[[nodiscard]] MONOSLAM_EVAL_EXPORT Eigen::Index landmarksFor(Eigen::Index pairs);
}  // namespace monoslam
