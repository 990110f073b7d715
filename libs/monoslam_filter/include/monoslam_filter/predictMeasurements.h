// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "monoslam_filter/Belief.h"
#include "monoslam_filter/export.h"
#include "monoslam_models/Camera.h"

namespace monoslam
{
/** Predicted measurement of one visible landmark: h, the two non-zero blocks of H, S with R. */
struct PredictedLandmark
{
    LandmarkId id = -1;
    Eigen::Index offset = 0;  ///< of the landmark in the state
    Eigen::Index size = 0;    ///< 6 or 3: the used columns of H_y
    Eigen::Vector2d h;        ///< [px]
    Eigen::Matrix<double, 2, 13> H_v;
    Eigen::Matrix<double, 2, 6> H_y;
    Eigen::Matrix2d S;  ///< H P H' + R, this landmark's block [px^2]
    Eigen::Matrix2d R;  ///< [px^2]
};

/** Joint prediction of the m visible landmarks of a belief. */
struct Prediction
{
    std::vector<PredictedLandmark> rows;
    Eigen::MatrixXd PHt;   ///< P H', N x 2m
    Eigen::MatrixXd HPHt;  ///< H P H' without R, 2m x 2m: the joint S is this plus block-diag(R)

    [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(rows.size()); }
};

/** What decides whether a projected landmark counts as visible. */
struct VisibilityOptions
{
    double border_px = 8.0;  ///< the centre stays this far inside the image
    double sigma_px = 1.0;   ///< R = sigma_px^2 I until a match brings its own
};

/** h, H and R of one landmark at the mean x; S is not set. Nothing if it is not visible from there. */
[[nodiscard]] MONOSLAM_FILTER_EXPORT std::optional<PredictedLandmark> linearizeLandmark(
    const Eigen::VectorXd& x, const LandmarkSlot& slot, const Camera& camera,
    const VisibilityOptions& options);

/** h, H, S of every landmark that is visible from the belief's mean.
 *
 *      PHt = P(:, v) H_v' + P(:, y) H_y',   HPHt = H PHt                     (sparse: 13 + 6 columns)
 *
 * O(N m) and O(m^2). \param admit  called with the index in belief.landmarks; false leaves it out */
[[nodiscard]] MONOSLAM_FILTER_EXPORT Prediction
predictMeasurements(const Belief& belief, const Camera& camera, const VisibilityOptions& options,
                    const std::function<bool(Eigen::Index)>& admit = {});
}  // namespace monoslam
