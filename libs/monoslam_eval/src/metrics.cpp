// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/metrics.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <functional>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kRpeInterval_s = 1.0;
constexpr double kRpeTolerance_s = 0.02;

double rotationAngle(const Eigen::Vector4d& q_a, const Eigen::Vector4d& q_b)
{
    const Eigen::Vector4d q = quaternionProduct(quaternionConjugate(q_a), q_b);
    return 2.0 * std::atan2(q.tail<3>().norm(), std::abs(q[0]));
}

struct CenteredPositions
{
    Eigen::Vector3d mean_x = Eigen::Vector3d::Zero();
    Eigen::Vector3d mean_y = Eigen::Vector3d::Zero();
    double variance_x = 0.0;
    Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
};

CenteredPositions center(const std::vector<PosePair>& pairs)
{
    CenteredPositions c;
    const double n = static_cast<double>(pairs.size());
    for (const PosePair& pair : pairs)
    {
        c.mean_x += pair.estimate.r_wc / n;
        c.mean_y += pair.truth.r_wc / n;
    }
    for (const PosePair& pair : pairs)
    {
        const Eigen::Vector3d x = pair.estimate.r_wc - c.mean_x;
        c.variance_x += x.squaredNorm() / n;
        c.C += (pair.truth.r_wc - c.mean_y) * x.transpose() / n;
    }
    return c;
}

/** Relative pose error E = (Q_i^-1 Q_j)^-1 (P_i^-1 P_j) over every (i, partner(i)). */
void relativeErrors(const std::vector<PosePair>& pairs,
                    const std::function<std::size_t(std::size_t)>& partner, Statistics& position,
                    Statistics& rotation)
{
    std::vector<double> lengths, angles;
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        const std::size_t j = partner(i);
        if (j >= pairs.size() || j <= i) continue;
        const auto& [k0, P_i, Q_i] = pairs[i];
        const auto& [k1, P_j, Q_j] = pairs[j];
        const Eigen::Vector3d dP = rotateInverse(P_i.q_wc, P_j.r_wc - P_i.r_wc);
        const Eigen::Vector3d dQ = rotateInverse(Q_i.q_wc, Q_j.r_wc - Q_i.r_wc);
        lengths.push_back((dP - dQ).norm());
        angles.push_back(rotationAngle(quaternionProduct(quaternionConjugate(Q_i.q_wc), Q_j.q_wc),
                                       quaternionProduct(quaternionConjugate(P_i.q_wc), P_j.q_wc)));
    }
    position = statistics(lengths);
    rotation = statistics(angles);
}

/** The pair nearest to one second after pair i, or none. */
std::size_t oneSecondLater(const std::vector<PosePair>& pairs, std::size_t i)
{
    const double t_s = pairs[i].estimate.t_s + kRpeInterval_s;
    std::size_t best = pairs.size();
    double bestDistance_s = kRpeTolerance_s;
    for (std::size_t j = i + 1; j < pairs.size(); ++j)
    {
        const double distance_s = std::abs(pairs[j].estimate.t_s - t_s);
        if (distance_s <= bestDistance_s)
        {
            best = j;
            bestDistance_s = distance_s;
        }
        if (pairs[j].estimate.t_s > t_s + kRpeTolerance_s) break;
    }
    return best;
}
}  // namespace

Statistics statistics(std::vector<double> errors)
{
    Statistics s;
    s.count = static_cast<long>(errors.size());
    if (errors.empty()) return s;
    std::sort(errors.begin(), errors.end());
    const Eigen::Map<const Eigen::VectorXd> e(errors.data(), s.count);
    const std::size_t half = errors.size() / 2;
    s.rmse = std::sqrt(e.squaredNorm() / static_cast<double>(s.count));
    s.mean = e.mean();
    s.median = errors.size() % 2 == 1 ? errors[half] : 0.5 * (errors[half - 1] + errors[half]);
    s.max = errors.back();
    return s;
}

StampedPose transform(const Similarity& similarity, StampedPose pose)
{
    pose.r_wc = similarity.s * similarity.R * pose.r_wc + similarity.t;
    pose.q_wc = quaternionProduct(quaternionFromMatrix(similarity.R), pose.q_wc);
    return pose;
}

Similarity align(const std::vector<PosePair>& pairs, Alignment alignment)
{
    Similarity fit;
    if (alignment == Alignment::None || pairs.size() < 3) return fit;
    const CenteredPositions c = center(pairs);
    if (!(c.variance_x > 0.0)) return fit;
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(c.C, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d W(1.0, 1.0, 1.0);
    if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0) W[2] = -1.0;
    fit.R = svd.matrixU() * W.asDiagonal() * svd.matrixV().transpose();
    if (alignment == Alignment::Sim3) fit.s = svd.singularValues().dot(W) / c.variance_x;
    fit.t = c.mean_y - fit.s * fit.R * c.mean_x;
    return fit;
}

Similarity alignFirstPose(const std::vector<PosePair>& pairs, Alignment alignment)
{
    Similarity fit;
    if (pairs.empty()) return fit;
    const StampedPose& x = pairs.front().estimate;
    const StampedPose& y = pairs.front().truth;
    fit.s = align(pairs, alignment).s;
    fit.R = rotationMatrix(quaternionProduct(y.q_wc, quaternionConjugate(x.q_wc)));
    fit.t = y.r_wc - fit.s * fit.R * x.r_wc;
    return fit;
}

TrajectoryErrors trajectoryErrors(const std::vector<PosePair>& pairs, Alignment alignment)
{
    TrajectoryErrors errors;
    errors.alignment = align(pairs, alignment);
    std::vector<PosePair> aligned = pairs;
    std::vector<double> lengths, angles;
    for (PosePair& pair : aligned)
    {
        pair.estimate = transform(errors.alignment, pair.estimate);
        lengths.push_back((pair.estimate.r_wc - pair.truth.r_wc).norm());
        angles.push_back(rotationAngle(pair.estimate.q_wc, pair.truth.q_wc));
    }
    errors.position_m = statistics(lengths);
    errors.rotation_rad = statistics(angles);
    relativeErrors(
        aligned, [](std::size_t i) { return i + 1; }, errors.stepPosition_m,
        errors.stepRotation_rad);
    relativeErrors(
        aligned, [&](std::size_t i) { return oneSecondLater(aligned, i); }, errors.secondPosition_m,
        errors.secondRotation_rad);
    return errors;
}

Statistics rotationErrors(const std::vector<PosePair>& pairs)
{
    Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
    for (const PosePair& pair : pairs)
        C += rotationMatrix(pair.truth.q_wc) * rotationMatrix(pair.estimate.q_wc).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(C, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d W(1.0, 1.0, 1.0);
    if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0) W[2] = -1.0;
    Similarity rotation;
    rotation.R = svd.matrixU() * W.asDiagonal() * svd.matrixV().transpose();
    std::vector<double> angles;
    for (const PosePair& pair : pairs)
        angles.push_back(rotationAngle(transform(rotation, pair.estimate).q_wc, pair.truth.q_wc));
    return statistics(angles);
}
}  // namespace monoslam
