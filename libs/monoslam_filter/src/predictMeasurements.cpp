// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/predictMeasurements.h"

namespace monoslam
{
namespace
{
using camera_state::kPoseSize;
using camera_state::kSize;

/** Columns of H_v that can be non-zero: the velocities matter for a rolling shutter only. */
Eigen::Index cameraColumns(const Camera& camera)
{
    return camera.parameters().readout_s > 0.0 ? kSize : kPoseSize;
}

void projectVisible(const Belief& belief, const Camera& camera, const VisibilityOptions& options,
                    const std::function<bool(Eigen::Index)>& admit, Prediction& prediction)
{
    prediction.rows.reserve(belief.landmarks.size());
    for (std::size_t i = 0; i < belief.landmarks.size(); ++i)
    {
        if (admit && !admit(static_cast<Eigen::Index>(i))) continue;
        const auto row = linearizeLandmark(belief.x, belief.landmarks[i], camera, options);
        if (row) prediction.rows.push_back(*row);
    }
}
}  // namespace

std::optional<PredictedLandmark> linearizeLandmark(const Eigen::VectorXd& x,
                                                   const LandmarkSlot& slot, const Camera& camera,
                                                   const VisibilityOptions& options)
{
    const auto projected =
        projectLandmark(camera, x.head<kSize>(), slot.kind, x.segment(slot.offset, slot.size()));
    if (!projected || !camera.contains(projected->h, options.border_px)) return std::nullopt;
    PredictedLandmark row;
    row.id = slot.id;
    row.offset = slot.offset;
    row.size = slot.size();
    row.h = projected->h;
    row.H_v = projected->J_h_xv;
    row.H_y = projected->J_h_y;
    row.R = options.sigma_px * options.sigma_px * Eigen::Matrix2d::Identity();
    return row;
}

Prediction predictMeasurements(const Belief& belief, const Camera& camera,
                               const VisibilityOptions& options,
                               const std::function<bool(Eigen::Index)>& admit)
{
    Prediction prediction;
    projectVisible(belief, camera, options, admit, prediction);

    const Eigen::Index m = prediction.count();
    const Eigen::Index nv = cameraColumns(camera);
    Eigen::MatrixXd Hvt(nv, 2 * m);
    for (Eigen::Index i = 0; i < m; ++i)
        Hvt.middleCols<2>(2 * i) =
            prediction.rows[static_cast<std::size_t>(i)].H_v.leftCols(nv).transpose();

    prediction.PHt.noalias() = belief.P.leftCols(nv) * Hvt;
    for (Eigen::Index i = 0; i < m; ++i)
    {
        const PredictedLandmark& row = prediction.rows[static_cast<std::size_t>(i)];
        const auto P_y = belief.P.middleCols(row.offset, row.size);
        prediction.PHt.middleCols<2>(2 * i).noalias() +=
            P_y.lazyProduct(row.H_y.leftCols(row.size).transpose());
    }
    prediction.HPHt.noalias() = Hvt.transpose() * prediction.PHt.topRows(nv);
    for (Eigen::Index i = 0; i < m; ++i)
    {
        PredictedLandmark& row = prediction.rows[static_cast<std::size_t>(i)];
        const auto PHt_y = prediction.PHt.middleRows(row.offset, row.size);
        prediction.HPHt.middleRows<2>(2 * i).noalias() +=
            row.H_y.leftCols(row.size).lazyProduct(PHt_y);
        const Eigen::Matrix2d own = prediction.HPHt.block<2, 2>(2 * i, 2 * i);
        row.S = 0.5 * (own + own.transpose()) + row.R;
    }
    return prediction;
}
}  // namespace monoslam
