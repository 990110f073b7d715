// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/SurfaceSlope.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace monoslam
{
namespace
{
constexpr double kPriorSigma = 0.5;   ///< tangent of 27 degrees
constexpr double kRepeated = 0.25;    ///< share of a measurement that is new
constexpr double kLeastSigma = 0.05;  ///< the surface is no plane: it is never known better
}  // namespace

Eigen::Matrix<double, 3, 2> axesAcross(const Eigen::Vector3d& ray)
{
    const Eigen::Vector3d first = ray.unitOrthogonal();
    Eigen::Matrix<double, 3, 2> axes;
    axes << first, ray.cross(first);
    return axes;
}

SlopeEstimate SurfaceSlope::around(const Eigen::Vector2d& expected) const
{
    const Eigen::Matrix2d prior = Eigen::Matrix2d::Identity() / (kPriorSigma * kPriorSigma);
    SlopeEstimate estimate;
    estimate.information = prior + information_;
    estimate.mean = estimate.information.inverse() * (prior * expected + eta_);
    return estimate;
}

void SurfaceSlope::learn(const SlopeEstimate& measured)
{
    information_ += kRepeated * measured.information;
    eta_ += kRepeated * (measured.information * measured.mean);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(information_);
    const double most = 1.0 / (kLeastSigma * kLeastSigma);
    if (!(solver.eigenvalues()(1) > most)) return;
    const Eigen::Vector2d mean =
        (information_ + 1e-9 * Eigen::Matrix2d::Identity()).inverse() * eta_;
    information_ = solver.eigenvectors() * solver.eigenvalues().cwiseMin(most).asDiagonal() *
                   solver.eigenvectors().transpose();
    eta_ = information_ * mean;
}
}  // namespace monoslam
