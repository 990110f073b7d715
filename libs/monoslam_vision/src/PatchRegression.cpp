// SPDX-License-Identifier: BSD-3-Clause
#include "PatchRegression.h"

namespace monoslam
{
PatchRegression::PatchRegression(const Patch& patch)
    : patch_(patch), A_(static_cast<Eigen::Index>(patch.side()) * patch.side(), kUnknowns)
{
    const Eigen::Matrix2f E0 = patch.stretch[0].cast<float>();
    const Eigen::Matrix2f E1 = patch.stretch[1].cast<float>();
    Eigen::Index row = 0;
    for (int dy = -patch.half_px; dy <= patch.half_px; ++dy)
        for (int dx = -patch.half_px; dx <= patch.half_px; ++dx, ++row)
        {
            const Eigen::Vector2f gradient(0.5F * (patch.at(dx + 1, dy) - patch.at(dx - 1, dy)),
                                           0.5F * (patch.at(dx, dy + 1) - patch.at(dx, dy - 1)));
            const Eigen::Vector2f d(static_cast<float>(dx), static_cast<float>(dy));
            A_.row(row) << gradient.x(), gradient.y(), gradient.dot(E0 * d), gradient.dot(E1 * d),
                patch.at(dx, dy), 1.0F;
        }
    pixels_ = (A_.transpose() * A_).cast<double>();
}

PatchRegression::Unknowns PatchRegression::fit(const PatchSamples& samples,
                                               const Eigen::Vector2d& slope, double gain,
                                               double variance)
{
    const Eigen::Matrix2d prior = variance * patch_.slope.information;
    Matrix6d normal = pixels_;
    normal.block<2, 2>(kSlope, kSlope) += prior;
    Unknowns b = (A_.transpose() * samples).cast<double>();
    b.segment<2>(kSlope) += prior * (gain * (patch_.slope.mean - slope));
    ldlt_.compute(normal);
    return ldlt_.solve(b);
}

double PatchRegression::variance(const PatchSamples& samples, const Unknowns& x) const
{
    const Eigen::Matrix<float, kUnknowns, 1> x_f = x.cast<float>();
    const auto freedom = static_cast<double>(A_.rows() - A_.cols());
    return static_cast<double>((samples - A_ * x_f).squaredNorm()) / freedom;
}

Eigen::Matrix2d PatchRegression::shiftCovariance() const
{
    const Eigen::Matrix<double, kUnknowns, 2> unit =
        Eigen::Matrix<double, kUnknowns, 2>::Identity();
    const Eigen::Matrix2d covariance = ldlt_.solve(unit).topRows<2>();
    return 0.5 * (covariance + covariance.transpose());
}

Eigen::Matrix2d PatchRegression::slopeInformation() const
{
    Eigen::Matrix4d others;
    others << pixels_.topLeftCorner<2, 2>(), pixels_.topRightCorner<2, 2>(),
        pixels_.bottomLeftCorner<2, 2>(), pixels_.bottomRightCorner<2, 2>();
    Eigen::Matrix<double, 4, 2> cross;
    cross << pixels_.block<2, 2>(0, kSlope), pixels_.block<2, 2>(kGain, kSlope);
    const Eigen::Matrix2d information =
        pixels_.block<2, 2>(kSlope, kSlope) - cross.transpose() * others.ldlt().solve(cross);
    return 0.5 * (information + information.transpose());
}
}  // namespace monoslam
