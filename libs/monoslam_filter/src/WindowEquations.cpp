// SPDX-License-Identifier: BSD-3-Clause
#include "WindowEquations.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kWeak = 1e-4;  ///< information that keeps what nothing was seen of regular
constexpr double kBadObservation = 1e4;  ///< cost of a landmark that cannot be projected

/** 7 x 6 map from (dr, dtheta) to the change of (r, q), q (x) (1, dtheta / 2). */
Eigen::Matrix<double, 7, 6> poseTangent(const Vector7d& pose)
{
    Eigen::Matrix4d QL;
    (void)quaternionProduct(pose.tail<4>(), Eigen::Vector4d::UnitX(), nullptr, &QL);
    Eigen::Matrix<double, 7, 6> T = Eigen::Matrix<double, 7, 6>::Zero();
    T.topLeftCorner<3, 3>().setIdentity();
    T.bottomRightCorner<4, 3>() = 0.5 * QL.rightCols<3>();
    return T;
}

}  // namespace

WindowEquations::WindowEquations(const Camera& camera, const Window& window,
                                 const WindowOptions& options)
    : camera_(camera),
      window_(window),
      options_(options),
      poseSize_(kPoseDof * static_cast<Eigen::Index>(window.poses.size())),
      inlier_(window.observations.size(), true),
      anchor_(window.poses.front()),
      baseline_(window.poses.back().head<3>() - anchor_.head<3>())
{
}

double WindowEquations::evaluate(const Window& at, bool linearize)
{
    if (linearize) clear(at.landmarks.size());
    double cost = posePrior(at, linearize);
    cost += scalePrior(at, linearize);
    for (std::size_t i = 0; i < at.landmarks.size(); ++i) cost += landmarkPrior(at, i, linearize);
    for (std::size_t i = 0; i < at.observations.size(); ++i)
        if (inlier_[i]) cost += observation(at, i, linearize);
    return cost;
}

double WindowEquations::squaredSigmas(const Window& at, std::size_t i) const
{
    const auto& landmark = at.landmarks[static_cast<std::size_t>(at.observations[i].landmark)];
    if (landmark.kind == LandmarkKind::InverseDepth && landmark.y(inverse_depth::kRho) <= 0.0)
        return options_.outlierChi2;
    return whitened(at, i, nullptr, nullptr).squaredNorm();
}

double WindowEquations::truncatedCost(const Window& at) const
{
    double sum = 0.0;
    for (std::size_t i = 0; i < at.observations.size(); ++i)
        sum += std::min(squaredSigmas(at, i), options_.outlierChi2);
    return 0.5 * sum;
}

double WindowEquations::markOutliers(const Window& at)
{
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < at.observations.size(); ++i)
    {
        const double chi2 = squaredSigmas(at, i);
        inlier_[i] = chi2 < options_.outlierChi2;
        if (!inlier_[i]) continue;
        sum += chi2;
        ++count;
    }
    return count > 0 ? sum / count : 0.0;
}

void WindowEquations::clear(std::size_t landmarks)
{
    H_pp_ = kWeak * Eigen::MatrixXd::Identity(poseSize_, poseSize_);
    b_p_ = Eigen::VectorXd::Zero(poseSize_);
    H_ll_.assign(landmarks, Eigen::Matrix3d(kWeak * Eigen::Matrix3d::Identity()));
    H_pl_.assign(landmarks, Eigen::MatrixXd::Zero(poseSize_, 3));
    b_l_.assign(landmarks, Eigen::Vector3d::Zero());
}

double WindowEquations::posePrior(const Window& at, bool linearize)
{
    Eigen::Matrix<double, 6, 1> off;
    off.head<3>() = anchor_.head<3>() - at.poses.front().head<3>();
    off.tail<3>() = quaternionLog(
        quaternionProduct(quaternionConjugate(at.poses.front().tail<4>()), anchor_.tail<4>()));
    if (linearize)
    {
        H_pp_.topLeftCorner<6, 6>() += window_.firstPoseInformation;
        b_p_.head<6>() += window_.firstPoseInformation * off;
    }
    return 0.5 * off.dot(window_.firstPoseInformation * off);
}

double WindowEquations::scalePrior(const Window& at, bool linearize)
{
    const double length = baseline_.norm();
    const bool unit = window_.scaleSigma > 0.0 && length > 0.0;
    const Eigen::Vector3d n = unit ? Eigen::Vector3d(baseline_ / length) : baseline_;
    const double weight = unit ? std::pow(window_.scaleSigma * length, -2.0) : 0.0;
    const double gap = length - n.dot(at.poses.back().head<3>() - at.poses.front().head<3>());
    if (linearize)
    {
        const Eigen::Index last = poseSize_ - kPoseDof;
        const Eigen::Matrix3d nn = weight * n * n.transpose();
        H_pp_.block<3, 3>(0, 0) += nn;
        H_pp_.block<3, 3>(last, last) += nn;
        H_pp_.block<3, 3>(0, last) -= nn;
        H_pp_.block<3, 3>(last, 0) -= nn;
        b_p_.segment<3>(last) += weight * gap * n;
        b_p_.head<3>() -= weight * gap * n;
    }
    return 0.5 * weight * gap * gap;
}

double WindowEquations::landmarkPrior(const Window& at, std::size_t i, bool linearize)
{
    const WindowLandmark& landmark = at.landmarks[i];
    const Eigen::Vector3d d = landmark.priorMean - landmark.y.segment<3>(freeOffset(landmark.kind));
    if (linearize)
    {
        H_ll_[i].diagonal() += landmark.priorInformation;
        b_l_[i] += landmark.priorInformation.asDiagonal() * d;
    }
    return 0.5 * d.dot(landmark.priorInformation.asDiagonal() * d);
}

Eigen::Vector2d WindowEquations::whitened(const Window& at, std::size_t i, Matrix26d* J_pose,
                                          Matrix23d* J_landmark) const
{
    const WindowObservation& seen = at.observations[i];
    const Vector7d& pose = at.poses[static_cast<std::size_t>(seen.view)];
    const WindowLandmark& landmark = at.landmarks[static_cast<std::size_t>(seen.landmark)];
    Vector13d x_v = Vector13d::Zero();
    x_v.head<7>() = pose;
    const auto projected = projectLandmark(camera_, x_v, landmark.kind, landmark.y);
    if (!projected) return Eigen::Vector2d::Constant(kBadObservation);
    const Eigen::LLT<Eigen::Matrix2d> llt(seen.R);
    const Eigen::Vector2d residual = llt.matrixL().solve(seen.z - projected->h);
    if (J_pose)
    {
        const Matrix26d J = projected->J_h_xv.leftCols<7>() * poseTangent(pose);
        *J_pose = llt.matrixL().solve(J);
        const Matrix23d J_y = projected->J_h_y.middleCols<3>(freeOffset(landmark.kind));
        *J_landmark = llt.matrixL().solve(J_y);
    }
    return residual;
}

double WindowEquations::observation(const Window& at, std::size_t i, bool linearize)
{
    Matrix26d J_p;
    Matrix23d J_l;
    const Eigen::Vector2d e =
        whitened(at, i, linearize ? &J_p : nullptr, linearize ? &J_l : nullptr);
    const double length = e.norm();
    const double k = options_.huber_sigmas;
    if (length >= kBadObservation) return k * (length - 0.5 * k);
    const double weight = length <= k ? 1.0 : k / length;
    if (linearize)
    {
        const Eigen::Index at6 = kPoseDof * at.observations[i].view;
        const auto l = static_cast<std::size_t>(at.observations[i].landmark);
        H_pp_.block<6, 6>(at6, at6) += weight * J_p.transpose() * J_p;
        H_pl_[l].middleRows<6>(at6) += weight * J_p.transpose() * J_l;
        H_ll_[l] += weight * J_l.transpose() * J_l;
        b_p_.segment<6>(at6) += weight * J_p.transpose() * e;
        b_l_[l] += weight * J_l.transpose() * e;
    }
    return length <= k ? 0.5 * length * length : k * (length - 0.5 * k);
}
}  // namespace monoslam
