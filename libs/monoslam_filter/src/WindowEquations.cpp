// SPDX-License-Identifier: BSD-3-Clause
#include "WindowEquations.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kWeak = 1e-4;  ///< information that keeps what nothing was seen of regular
constexpr double kBadObservation = 1e4;  ///< cost of a landmark that cannot be projected

}  // namespace

WindowEquations::WindowEquations(const Camera& camera, const Window& window,
                                 const WindowOptions& options)
    : camera_(camera),
      window_(window),
      options_(options),
      poseSize_(kPoseDof * static_cast<Eigen::Index>(window.poses.size())),
      inlier_(window.observations.size(), true),
      anchor_(window.poses.front()),
      baseline_(window.poses.back().head<3>() - anchor_.head<3>()),
      H_pp_(poseSize_, poseSize_),
      b_p_(poseSize_),
      H_ll_(window.landmarks.size()),
      H_pl_(poseSize_, 3 * static_cast<Eigen::Index>(window.landmarks.size())),
      b_l_(window.landmarks.size())
{
    whiten_.reserve(window.observations.size());
    for (const WindowObservation& seen : window.observations)
        whiten_.emplace_back(
            Eigen::LLT<Eigen::Matrix2d>(seen.R).matrixL().solve(Eigen::Matrix2d::Identity()));
}

WindowEquations::Geometry::Geometry(const Window& at)
{
    views.reserve(at.poses.size());
    for (const Vector7d& pose : at.poses) views.emplace_back(pose);
    landmarks.reserve(at.landmarks.size());
    for (const WindowLandmark& landmark : at.landmarks)
        landmarks.emplace_back(landmark.kind, landmark.y);
}

double WindowEquations::evaluate(const Window& at, bool linearize)
{
    if (linearize) clear();
    const Geometry geometry(at);
    double cost = posePrior(at, linearize);
    cost += scalePrior(at, linearize);
    for (std::size_t i = 0; i < at.landmarks.size(); ++i) cost += landmarkPrior(at, i, linearize);
    for (std::size_t i = 0; i < at.observations.size(); ++i)
        if (inlier_[i]) cost += observation(geometry, i, linearize);
    return cost;
}

double WindowEquations::squaredSigmas(const Geometry& at, std::size_t i) const
{
    const WindowObservation& seen = window_.observations[i];
    const LandmarkRay& landmark = at.landmarks[static_cast<std::size_t>(seen.landmark)];
    if (landmark.rho <= 0.0) return options_.outlierChi2;
    const auto h = projectRay(camera_, at.views[static_cast<std::size_t>(seen.view)], landmark);
    if (!h) return kBadObservation * kBadObservation;
    return (whiten_[i] * (seen.z - *h)).squaredNorm();
}

double WindowEquations::truncatedCost(const Window& at) const
{
    const Geometry geometry(at);
    double sum = 0.0;
    for (std::size_t i = 0; i < at.observations.size(); ++i)
        sum += std::min(squaredSigmas(geometry, i), options_.outlierChi2);
    return 0.5 * sum;
}

double WindowEquations::markOutliers(const Window& at)
{
    const Geometry geometry(at);
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < at.observations.size(); ++i)
    {
        const double chi2 = squaredSigmas(geometry, i);
        inlier_[i] = chi2 < options_.outlierChi2;
        if (!inlier_[i]) continue;
        sum += chi2;
        ++count;
    }
    return count > 0 ? sum / count : 0.0;
}

void WindowEquations::clear()
{
    H_pp_.setZero();
    H_pp_.diagonal().setConstant(kWeak);
    b_p_.setZero();
    H_pl_.setZero();
    std::fill(H_ll_.begin(), H_ll_.end(), Eigen::Matrix3d(kWeak * Eigen::Matrix3d::Identity()));
    std::fill(b_l_.begin(), b_l_.end(), Eigen::Vector3d(Eigen::Vector3d::Zero()));
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

double WindowEquations::observation(const Geometry& at, std::size_t i, bool linearize)
{
    const WindowObservation& seen = window_.observations[i];
    const ViewPose& view = at.views[static_cast<std::size_t>(seen.view)];
    const LandmarkRay& landmark = at.landmarks[static_cast<std::size_t>(seen.landmark)];
    std::optional<TangentProjection> projected;
    std::optional<Eigen::Vector2d> h;
    if (linearize)
    {
        projected = projectOnTangent(camera_, view, landmark);
        if (projected) h = projected->h;
    }
    else
        h = projectRay(camera_, view, landmark);
    const double k = options_.huber_sigmas;
    if (!h) return k * (kBadObservation - 0.5 * k);
    const Eigen::Vector2d e = whiten_[i] * (seen.z - *h);
    const double length = e.norm();
    const double weight = length <= k ? 1.0 : k / length;
    if (linearize) accumulate(seen, whiten_[i], *projected, e, weight);
    return length <= k ? 0.5 * length * length : k * (length - 0.5 * k);
}

void WindowEquations::accumulate(const WindowObservation& seen, const Eigen::Matrix2d& whiten,
                                 const TangentProjection& projected, const Eigen::Vector2d& e,
                                 double w)
{
    const Eigen::Matrix<double, 2, 6> J_p = whiten * projected.J_h_pose;
    const Eigen::Matrix<double, 2, 3> J_l = whiten * projected.J_h_landmark;
    const Eigen::Matrix<double, 6, 2> wJ_p = w * J_p.transpose();
    const Eigen::Matrix<double, 3, 2> wJ_l = w * J_l.transpose();
    const Eigen::Index at6 = kPoseDof * seen.view;
    const auto l = static_cast<std::size_t>(seen.landmark);
    H_pp_.block<6, 6>(at6, at6).noalias() += wJ_p * J_p;
    H_pl_.block<6, 3>(at6, 3 * seen.landmark).noalias() += wJ_p * J_l;
    H_ll_[l].noalias() += wJ_l * J_l;
    b_p_.segment<6>(at6).noalias() += wJ_p * e;
    b_l_[l].noalias() += wJ_l * e;
}
}  // namespace monoslam
