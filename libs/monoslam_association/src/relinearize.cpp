// SPDX-License-Identifier: BSD-3-Clause
#include "relinearize.h"

#include <Eigen/LU>

namespace monoslam
{
namespace
{
/** Error of the linearised projection, in standard deviations of the pixel's noise, below which it does
 *  not matter. */
constexpr double kLinearEnough_sigmas = 3.0;
}  // namespace

Prediction predictAt(const FrameView& view, Belief& prior, Eigen::VectorXd x)
{
    prior.x.swap(x);  // for a moment: a copy would copy the covariance too
    Prediction prediction = view.predict(prior);
    prior.x.swap(x);
    const Eigen::VectorXd back = prior.x - x;
    for (PredictedLandmark& row : prediction.rows)
        row.h += row.H_v * back.head<camera_state::kSize>() +
                 row.H_y.leftCols(row.size) * back.segment(row.offset, row.size);
    return prediction;
}

bool linearEnough(const Prediction& prediction, const std::vector<PixelMeasurement>& pixels,
                  const Belief& prior, const Eigen::VectorXd& x, const FrameView& view)
{
    const Eigen::VectorXd step = x - prior.x;
    for (const PixelMeasurement& pixel : pixels)
    {
        const auto& row = prediction.rows[static_cast<std::size_t>(pixel.row)];
        const auto slot = static_cast<std::size_t>(prior.find(row.id));
        const auto seen = view.linearize(x, prior.landmarks[slot]);
        if (!seen) continue;
        const Eigen::Vector2d e = seen->h - row.h - row.H_v * step.head<camera_state::kSize>() -
                                  row.H_y.leftCols(row.size) * step.segment(row.offset, row.size);
        if (e.dot(pixel.R.inverse() * e) >= kLinearEnough_sigmas * kLinearEnough_sigmas)
            return false;
    }
    return true;
}

std::map<LandmarkId, Eigen::Index> rowsById(const Prediction& prediction)
{
    std::map<LandmarkId, Eigen::Index> rowOf;
    for (std::size_t row = 0; row < prediction.rows.size(); ++row)
        rowOf[prediction.rows[row].id] = static_cast<Eigen::Index>(row);
    return rowOf;
}

std::vector<PixelMeasurement> onRowsOf(const Prediction& to, const Prediction& from,
                                       const std::vector<PixelMeasurement>& pixels)
{
    const std::map<LandmarkId, Eigen::Index> rowOf = rowsById(to);
    std::vector<PixelMeasurement> moved;
    for (PixelMeasurement pixel : pixels)
    {
        const auto row = rowOf.find(from.rows[static_cast<std::size_t>(pixel.row)].id);
        if (row == rowOf.end()) continue;
        pixel.row = row->second;
        moved.push_back(pixel);
    }
    return moved;
}
}  // namespace monoslam
