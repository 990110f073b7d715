// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "monoslam_filter/FilterEngine.h"
#include "monoslam_models/Camera.h"
#include "monoslam_mrpt/export.h"

/** MRPT's EKF-SLAM, mrpt::bayes::CKalmanFilterCapable<13, 2, 6, 0>, on our models: an oracle for
 *  ekf.h and the baseline of [filter] engine = mrpt. Its state has inverse-depth landmarks only;
 *  each function throws std::invalid_argument for a belief with points or pose clones. P is made
 *  symmetric after each iteration, without which MRPT's update diverges. */
namespace monoslam
{
/** predict: an MRPT iteration without observations. update: one without prediction, with the
 *  given rows of H; every pixel keeps its own noise, because MRPT, which has a single R for all
 *  landmarks, is given whitened pixels. The count of faults stays 0: MRPT inverts S unchecked. */
[[nodiscard]] MONOSLAM_MRPT_EXPORT FilterEngine makeMrptEngine();

/** The pixel of one landmark of a belief. */
struct LandmarkPixel
{
    LandmarkId id = -1;
    Eigen::Vector2d z;  ///< [px]
    Eigen::Matrix2d R;  ///< [px^2]
};

/** One whole MRPT iteration: predict, h, H and S of all landmarks, update with some of them.
 *  \throw std::invalid_argument also if a landmark is behind the camera, which MRPT cannot say */
[[nodiscard]] MONOSLAM_MRPT_EXPORT Belief mrptIteration(Belief belief, const Camera& camera,
                                                        const ConstantVelocityOptions& motion,
                                                        double dt_s,
                                                        const std::vector<LandmarkPixel>& pixels);
}  // namespace monoslam
