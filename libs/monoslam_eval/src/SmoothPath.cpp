// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/SmoothPath.h"

#include <cmath>
#include <random>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
using namespace camera_state;

namespace
{
constexpr double kDifference_s = 1e-4;
constexpr double kSlow_hz = 0.25, kFast_hz = 0.6;
constexpr double kFasterShare = 1.0 / 3.0;
}  // namespace

SmoothPath::SmoothPath(double amplitude_m, double amplitude_rad, unsigned seed)
{
    amplitude_ << Eigen::Vector3d::Constant(amplitude_m), Eigen::Vector3d::Constant(amplitude_rad);
    std::mt19937 rng(seed);
    std::uniform_real_distribution<double> factor(0.7, 1.3), phase(0.0, 2.0 * M_PI);
    for (Eigen::Index i = 0; i < rate_hz_.rows(); ++i)
        for (Eigen::Index j = 0; j < rate_hz_.cols(); ++j)
        {
            rate_hz_(i, j) = factor(rng) * (j == 0 ? kSlow_hz : kFast_hz);
            phase_rad_(i, j) = phase(rng);
        }
}

Vector7d SmoothPath::pose(double t_s) const
{
    const auto wave = [&](Eigen::Index i, Eigen::Index j)
    {
        return std::sin(2.0 * M_PI * rate_hz_(i, j) * t_s + phase_rad_(i, j)) -
               std::sin(phase_rad_(i, j));
    };
    Vector6 place;
    for (Eigen::Index i = 0; i < place.size(); ++i)
        place[i] = amplitude_[i] * (wave(i, 0) + kFasterShare * wave(i, 1));
    Vector7d pose;
    pose << place.head<3>(), quaternionExp(place.tail<3>());
    return pose;
}

Vector13d SmoothPath::at(double t_s) const
{
    const Vector7d before = pose(t_s - kDifference_s), after = pose(t_s + kDifference_s);
    Vector13d x_v;
    x_v.head<kPoseSize>() = pose(t_s);
    x_v.segment<3>(kVelocity) = (after - before).head<3>() / (2.0 * kDifference_s);
    x_v.segment<3>(kAngularVelocity) =
        quaternionLog(quaternionProduct(quaternionConjugate(before.tail<4>()), after.tail<4>())) /
        (2.0 * kDifference_s);
    return x_v;
}
}  // namespace monoslam
