// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "monoslam_association/Associator.h"

namespace monoslam
{
/** Prediction of the prior linearised at x: its h is h(x) + H (x_prior - x), so that z - h is the
 *  innovation of an iterated EKF. */
[[nodiscard]] Prediction predictAt(const FrameView& view, Belief& prior, Eigen::VectorXd x);

/** Whether the projection at x agrees with its linearisation in every pixel, to within a few standard
 *  deviations of the pixel's noise. The image bends with a turn, and a parallax is the product of two
 *  unknowns, movement and depth. */
[[nodiscard]] bool linearEnough(const Prediction& prediction,
                                const std::vector<PixelMeasurement>& pixels, const Belief& prior,
                                const Eigen::VectorXd& x, const FrameView& view);

/** Row of every landmark of a prediction. */
[[nodiscard]] std::map<LandmarkId, Eigen::Index> rowsById(const Prediction& prediction);

/** The same pixels as measurements of another prediction's rows, landmark by landmark. */
[[nodiscard]] std::vector<PixelMeasurement> onRowsOf(const Prediction& to, const Prediction& from,
                                                     const std::vector<PixelMeasurement>& pixels);
}  // namespace monoslam
