// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/ellipseMass.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace monoslam
{
namespace
{
constexpr double kFar = 6.0;  ///< standard deviations that hold all of a Gaussian
constexpr unsigned kNodes = 20;

double below(double x)
{
    return 0.5 * std::erfc(-x * M_SQRT1_2);
}
}  // namespace

double ellipseMass(const Eigen::Vector2d& mean, const Eigen::Matrix2d& C, const Eigen::Matrix2d& S,
                   double gate)
{
    // Whitened by S the ellipse is a disc, which may then be turned to the axes of C.
    const Eigen::LLT<Eigen::Matrix2d> llt(S);
    const Eigen::Matrix2d half = llt.matrixL().solve(C);
    const Eigen::Matrix2d D = llt.matrixL().solve(half.transpose());
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
    solver.computeDirect(0.5 * (D + D.transpose()));
    const Eigen::Vector2d sigma = solver.eigenvalues().cwiseMax(1e-12).cwiseSqrt();
    const Eigen::Vector2d m =
        solver.eigenvectors().transpose() * Eigen::Vector2d(llt.matrixL().solve(mean));
    const double r = std::sqrt(gate);
    if (m.norm() > r + kFar * sigma(1)) return 0.0;
    const double low = std::max(-r, m(1) - kFar * sigma(1));
    const double high = std::min(r, m(1) + kFar * sigma(1));
    if (!(low < high)) return 0.0;
    const auto slice = [&](double x)
    {
        const double e = (x - m(1)) / sigma(1);
        const double reach = std::sqrt(std::max(r * r - x * x, 0.0));
        const double inside = below((reach - m(0)) / sigma(0)) - below((-reach - m(0)) / sigma(0));
        return std::exp(-0.5 * e * e) / (sigma(1) * std::sqrt(2.0 * M_PI)) * inside;
    };
    return boost::math::quadrature::gauss<double, kNodes>::integrate(slice, low, high);
}
}  // namespace monoslam
