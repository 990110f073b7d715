// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "monoslam_eval/metrics.h"

namespace monoslam
{
namespace
{
constexpr double kLargestResidual = 0.2;

struct LocalScale
{
    double s = 1.0;
    bool reliable = false;
};

LocalScale localScale(const std::vector<PosePair>& pairs)
{
    const TrajectoryErrors errors = trajectoryErrors(pairs, Alignment::Sim3);
    LocalScale local;
    local.s = errors.alignment.s;
    local.reliable =
        pairs.size() >= 3 && errors.position_m.rmse < kLargestResidual * standingStillError(pairs);
    return local;
}
}  // namespace

double standingStillError(const std::vector<PosePair>& pairs)
{
    const double n = static_cast<double>(pairs.size());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const PosePair& pair : pairs) mean += pair.truth.r_wc / n;
    double variance = 0.0;
    for (const PosePair& pair : pairs) variance += (pair.truth.r_wc - mean).squaredNorm() / n;
    return std::sqrt(variance);
}

ScaleDrift scaleDrift(const std::vector<PosePair>& pairs)
{
    ScaleDrift result;
    const auto third = static_cast<std::ptrdiff_t>(pairs.size() / 3);
    if (third < 3) return result;
    const LocalScale first = localScale({pairs.begin(), pairs.begin() + third});
    const LocalScale last = localScale({pairs.end() - third, pairs.end()});
    result.first = first.s;
    result.last = last.s;
    result.drift = first.s / last.s - 1.0;
    result.reliable = first.reliable && last.reliable;
    return result;
}

OutAndBack outAndBack(const Trajectory& trajectory)
{
    OutAndBack result;
    if (trajectory.size() < 3) return result;
    const double n = static_cast<double>(trajectory.size());
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const StampedPose& pose : trajectory) mean += pose.r_wc / n;
    Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
    for (const StampedPose& pose : trajectory)
        C += (pose.r_wc - mean) * (pose.r_wc - mean).transpose();
    const Eigen::Vector3d line =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(C).eigenvectors().col(2);

    const Eigen::Vector3d start = trajectory.front().r_wc;
    const auto along = [&](const StampedPose& pose) { return line.dot(pose.r_wc - start); };
    const auto turn = std::max_element(trajectory.begin(), trajectory.end(),
                                       [&](const StampedPose& a, const StampedPose& b)
                                       { return std::abs(along(a)) < std::abs(along(b)); });
    for (const StampedPose& pose : trajectory)
    {
        const Eigen::Vector3d d = pose.r_wc - mean;
        result.offLine = std::max(result.offLine, (d - line * line.dot(d)).norm());
    }
    result.outLength = pathLength({trajectory.begin(), turn + 1});
    result.backLength = pathLength({turn, trajectory.end()});
    result.length = result.outLength + result.backLength;
    result.gap = (trajectory.back().r_wc - start).norm();
    result.outReach = std::abs(along(*turn));
    result.backReach = std::abs(along(*turn) - along(trajectory.back()));
    return result;
}
}  // namespace monoslam
