// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/smoothWindow.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Matrix26d = Eigen::Matrix<double, 2, 6>;

constexpr Eigen::Index kPoseDof = 6;
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

Vector7d movePose(const Vector7d& pose, const Eigen::Matrix<double, 6, 1>& d)
{
    Vector7d moved;
    moved.head<3>() = pose.head<3>() + d.head<3>();
    moved.tail<4>() =
        normalizeQuaternion(quaternionProduct(pose.tail<4>(), quaternionExp(d.tail<3>())));
    return moved;
}

/** The first of the three free numbers of a landmark within y. */
Eigen::Index freeOffset(LandmarkKind kind)
{
    return kind == LandmarkKind::InverseDepth ? inverse_depth::kTheta : 0;
}

/** Cost and normal equations of a window at one estimate. */
class NormalEquations
{
   public:
    NormalEquations(const Camera& camera, const Window& window, const WindowOptions& options)
        : camera_(camera),
          window_(window),
          options_(options),
          poseSize_(kPoseDof * static_cast<Eigen::Index>(window.poses.size())),
          inlier_(window.observations.size(), true)
    {
        const Vector7d& first = window.poses.front();
        anchor_ = first;
        baseline_ = window.poses.back().head<3>() - first.head<3>();
    }

    /** Robust cost; fills the equations if asked. */
    double evaluate(const Window& at, bool linearize)
    {
        if (linearize) clear(at.landmarks.size());
        double cost = priors(at, linearize);
        for (std::size_t i = 0; i < at.observations.size(); ++i)
            if (inlier_[i]) cost += observation(at, i, linearize);
        return cost;
    }

    /** Sum of half the squared sigmas, each cut at the outlier threshold: comparable between
     *  estimates of one window. */
    [[nodiscard]] double truncatedCost(const Window& at) const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < at.observations.size(); ++i)
            sum += std::min(whitened(at, i, nullptr, nullptr).squaredNorm(), options_.outlierChi2);
        return 0.5 * sum;
    }

    /** Marks what lies beyond the outlier threshold; returns the mean chi2 of the rest. */
    double markOutliers(const Window& at)
    {
        double sum = 0.0;
        int count = 0;
        for (std::size_t i = 0; i < at.observations.size(); ++i)
        {
            const double chi2 = whitened(at, i, nullptr, nullptr).squaredNorm();
            inlier_[i] = chi2 < options_.outlierChi2;
            if (!inlier_[i]) continue;
            sum += chi2;
            ++count;
        }
        return count > 0 ? sum / count : 0.0;
    }

    /** Solution of the damped equations applied to a copy of the window. */
    [[nodiscard]] Window step(const Window& at, double lambda) const
    {
        Eigen::MatrixXd S = H_pp_;
        S.diagonal() *= 1.0 + lambda;
        Eigen::VectorXd b = b_p_;
        std::vector<Eigen::Matrix3d> inverse(H_ll_.size());
        for (std::size_t i = 0; i < H_ll_.size(); ++i)
        {
            Eigen::Matrix3d damped = H_ll_[i];
            damped.diagonal() *= 1.0 + lambda;
            inverse[i] = damped.inverse();
            const Eigen::LLT<Eigen::Matrix3d> llt(inverse[i]);
            const Eigen::MatrixXd A = H_pl_[i] * Eigen::Matrix3d(llt.matrixL());
            S.selfadjointView<Eigen::Lower>().rankUpdate(A, -1.0);
            b -= H_pl_[i] * (inverse[i] * b_l_[i]);
        }
        const Eigen::LDLT<Eigen::MatrixXd, Eigen::Lower> ldlt(S);
        const Eigen::VectorXd d = ldlt.solve(b);
        Window moved = at;
        for (std::size_t k = 0; k < moved.poses.size(); ++k)
            moved.poses[k] = movePose(
                moved.poses[k], d.segment<kPoseDof>(kPoseDof * static_cast<Eigen::Index>(k)));
        for (std::size_t i = 0; i < moved.landmarks.size(); ++i)
        {
            const Eigen::Vector3d dl = inverse[i] * (b_l_[i] - H_pl_[i].transpose() * d);
            WindowLandmark& landmark = moved.landmarks[i];
            landmark.y.segment<3>(freeOffset(landmark.kind)) += dl;
        }
        return moved;
    }

    [[nodiscard]] Eigen::MatrixXd covariance() const;
    [[nodiscard]] const std::vector<bool>& inliers() const { return inlier_; }

   private:
    void clear(std::size_t landmarks)
    {
        H_pp_ = kWeak * Eigen::MatrixXd::Identity(poseSize_, poseSize_);
        b_p_ = Eigen::VectorXd::Zero(poseSize_);
        H_ll_.assign(landmarks, Eigen::Matrix3d(kWeak * Eigen::Matrix3d::Identity()));
        H_pl_.assign(landmarks, Eigen::MatrixXd::Zero(poseSize_, 3));
        b_l_.assign(landmarks, Eigen::Vector3d::Zero());
    }

    double priors(const Window& at, bool linearize);
    double observation(const Window& at, std::size_t i, bool linearize);
    [[nodiscard]] Eigen::Vector2d whitened(const Window& at, std::size_t i, Matrix26d* J_pose,
                                           Eigen::Matrix<double, 2, 3>* J_landmark) const;

    const Camera& camera_;
    const Window& window_;
    const WindowOptions& options_;
    Eigen::Index poseSize_;
    std::vector<bool> inlier_;
    Vector7d anchor_;
    Eigen::Vector3d baseline_;
    Eigen::MatrixXd H_pp_;
    Eigen::VectorXd b_p_;
    std::vector<Eigen::Matrix3d> H_ll_;
    std::vector<Eigen::MatrixXd> H_pl_;
    std::vector<Eigen::Vector3d> b_l_;
};

double NormalEquations::priors(const Window& at, bool linearize)
{
    Eigen::Matrix<double, 6, 1> off;
    off.head<3>() = anchor_.head<3>() - at.poses.front().head<3>();
    off.tail<3>() = quaternionLog(quaternionProduct(
        quaternionConjugate(at.poses.front().tail<4>()), anchor_.tail<4>()));
    double cost = 0.5 * off.dot(window_.firstPoseInformation * off);
    const double length = baseline_.norm();
    const bool unit = window_.scaleSigma > 0.0 && length > 0.0;
    const Eigen::Vector3d n = unit ? Eigen::Vector3d(baseline_ / length) : baseline_;
    const double weight = unit ? std::pow(window_.scaleSigma * length, -2.0) : 0.0;
    const double gap =
        length - n.dot(at.poses.back().head<3>() - at.poses.front().head<3>());
    cost += 0.5 * weight * gap * gap;
    for (std::size_t i = 0; i < at.landmarks.size(); ++i)
    {
        const WindowLandmark& landmark = at.landmarks[i];
        const Eigen::Vector3d d =
            landmark.priorMean - landmark.y.segment<3>(freeOffset(landmark.kind));
        cost += 0.5 * d.dot(landmark.priorInformation.asDiagonal() * d);
        if (!linearize) continue;
        H_ll_[i].diagonal() += landmark.priorInformation;
        b_l_[i] += landmark.priorInformation.asDiagonal() * d;
    }
    if (!linearize) return cost;
    H_pp_.topLeftCorner<6, 6>() += window_.firstPoseInformation;
    b_p_.head<6>() += window_.firstPoseInformation * off;
    const Eigen::Index last = poseSize_ - kPoseDof;
    const Eigen::Matrix3d nn = weight * n * n.transpose();
    H_pp_.block<3, 3>(0, 0) += nn;
    H_pp_.block<3, 3>(last, last) += nn;
    H_pp_.block<3, 3>(0, last) -= nn;
    H_pp_.block<3, 3>(last, 0) -= nn;
    b_p_.segment<3>(last) += weight * gap * n;
    b_p_.head<3>() -= weight * gap * n;
    return cost;
}

Eigen::Vector2d NormalEquations::whitened(const Window& at, std::size_t i, Matrix26d* J_pose,
                                          Eigen::Matrix<double, 2, 3>* J_landmark) const
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
        const Eigen::Matrix<double, 2, 3> J_y =
            projected->J_h_y.middleCols<3>(freeOffset(landmark.kind));
        *J_landmark = llt.matrixL().solve(J_y);
    }
    return residual;
}

double NormalEquations::observation(const Window& at, std::size_t i, bool linearize)
{
    Matrix26d J_p;
    Eigen::Matrix<double, 2, 3> J_l;
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

Eigen::MatrixXd NormalEquations::covariance() const
{
    const auto n = static_cast<Eigen::Index>(H_ll_.size());
    constexpr Eigen::Index kPoses = 3 * kPoseDof;
    Eigen::MatrixXd S = H_pp_;
    Eigen::MatrixXd G(3 * n, poseSize_);
    Eigen::MatrixXd P = Eigen::MatrixXd::Zero(kPoses + 3 * n, kPoses + 3 * n);
    for (Eigen::Index i = 0; i < n; ++i)
    {
        const auto l = static_cast<std::size_t>(i);
        const Eigen::Matrix3d inverse = H_ll_[l].inverse();
        G.middleRows<3>(3 * i) = inverse * H_pl_[l].transpose();
        S.noalias() -= H_pl_[l] * G.middleRows<3>(3 * i);
        P.block<3, 3>(kPoses + 3 * i, kPoses + 3 * i) = inverse;
    }
    const Eigen::LDLT<Eigen::MatrixXd> ldlt(S);
    const Eigen::MatrixXd cov = ldlt.solve(Eigen::MatrixXd::Identity(poseSize_, poseSize_));
    if (ldlt.info() != Eigen::Success || !ldlt.isPositive() || !cov.allFinite()) return {};
    const Eigen::MatrixXd Gc = G * cov;
    P.bottomRightCorner(3 * n, 3 * n).noalias() += Gc * G.transpose();
    constexpr Eigen::Index kLastTwo = 2 * kPoseDof;
    P.topLeftCorner<kPoseDof, kPoseDof>() = cov.topLeftCorner<kPoseDof, kPoseDof>();
    P.block<kPoseDof, kLastTwo>(0, kPoseDof) = cov.topRightCorner<kPoseDof, kLastTwo>();
    P.block<kLastTwo, kPoseDof>(kPoseDof, 0) = cov.bottomLeftCorner<kLastTwo, kPoseDof>();
    P.block<kLastTwo, kLastTwo>(kPoseDof, kPoseDof) = cov.bottomRightCorner<kLastTwo, kLastTwo>();
    P.bottomLeftCorner(3 * n, kPoseDof) = -Gc.leftCols<kPoseDof>();
    P.block(kPoses, kPoseDof, 3 * n, kLastTwo) = -Gc.rightCols<kLastTwo>();
    P.topRightCorner(kPoses, 3 * n) = P.bottomLeftCorner(3 * n, kPoses).transpose();
    return 0.5 * (P + P.transpose());
}

/** Levenberg-Marquardt until the cost stands still; returns the iterations used. */
int minimize(NormalEquations& equations, Window& window, const WindowOptions& options)
{
    double lambda = 1e-4;
    double cost = equations.evaluate(window, true);
    int iteration = 0;
    for (; iteration < options.maxIterations; ++iteration)
    {
        Window trial = equations.step(window, lambda);
        const double trialCost = equations.evaluate(trial, false);
        if (!(trialCost < cost))
        {
            lambda *= 10.0;
            if (lambda > 1e6) break;
            continue;
        }
        const double decrease = (cost - trialCost) / std::max(cost, 1e-12);
        window = std::move(trial);
        lambda = std::max(lambda * 0.1, 1e-9);
        cost = equations.evaluate(window, true);
        if (decrease < options.convergence) break;
    }
    return iteration;
}
}  // namespace

SmoothedWindow smoothWindow(const Camera& camera, Window window, const WindowOptions& options)
{
    if (window.poses.size() < 2)
        throw std::invalid_argument("smoothWindow: a window has two views or more");
    const Window given = window;
    NormalEquations equations(camera, given, options);
    SmoothedWindow result;
    result.iterations = minimize(equations, window, options);
    (void)equations.markOutliers(window);
    result.iterations += minimize(equations, window, options);
    result.meanChi2 = equations.markOutliers(window);
    result.cost = equations.truncatedCost(window);
    (void)equations.evaluate(window, true);
    result.P = equations.covariance();
    result.usable = result.P.size() > 0;
    result.inlier = equations.inliers();
    result.poses = std::move(window.poses);
    result.landmarks = std::move(window.landmarks);
    return result;
}
}  // namespace monoslam
