// SPDX-License-Identifier: BSD-3-Clause
#include "ConditionalPrediction.h"

namespace monoslam
{
ConditionalPrediction::ConditionalPrediction(const Prediction& prediction,
                                             const std::vector<PixelMeasurement>& accepted)
    : prediction_(prediction)
{
    const JointInnovation joint = stackInnovation(prediction, accepted);
    llt_.compute(joint.S);
    if (llt_.info() != Eigen::Success) return;
    e_ = llt_.matrixL().solve(joint.nu);
    valid_ = e_.allFinite();
    for (const PixelMeasurement& pixel : accepted) rows_.push_back(pixel.row);
}

ConditionalPrediction::Row ConditionalPrediction::row(Eigen::Index j) const
{
    Eigen::Matrix<double, Eigen::Dynamic, 2> Y(e_.size(), 2);
    for (std::size_t i = 0; i < rows_.size(); ++i)
        Y.middleRows<2>(2 * static_cast<Eigen::Index>(i)) =
            prediction_.HPHt.block<2, 2>(2 * rows_[i], 2 * j);
    llt_.matrixL().solveInPlace(Y);
    Row row;
    row.shift = Y.transpose() * e_;
    row.HPHt = prediction_.HPHt.block<2, 2>(2 * j, 2 * j) - Y.transpose() * Y;
    return row;
}
}  // namespace monoslam
