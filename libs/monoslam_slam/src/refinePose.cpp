// SPDX-License-Identifier: BSD-3-Clause
#include "refinePose.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

Eigen::Matrix3d skew(const Eigen::Vector3d& a)
{
    return (Eigen::Matrix3d() << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0).finished();
}

std::optional<PointTerm> pointTerm(const SeenPoints& seen, std::size_t i, const Camera& camera,
                                   const CameraPose& pose)
{
    const Eigen::Vector3d h_c = pose.R_wc.transpose() * (seen.points_m[i] - pose.r_wc);
    Matrix23d J_uv_h;
    const auto uv_px = camera.project(h_c, &J_uv_h);
    if (!uv_px) return std::nullopt;
    PointTerm term;
    term.nu = seen.pixels_px[i] - *uv_px;
    term.J_uv_p = J_uv_h * pose.R_wc.transpose();
    term.J_uv_pose << -term.J_uv_p, J_uv_h * skew(h_c);
    const Eigen::Matrix2d R =
        std::pow(seen.sigmas_px[i], 2) * Eigen::Matrix2d::Identity() +
        std::pow(seen.point_sigma_m, 2) * term.J_uv_p * term.J_uv_p.transpose();
    term.weight = R.inverse();
    return term;
}

CameraPose moved(const CameraPose& pose, const Vector6d& step)
{
    const Eigen::Vector4d dq = quaternionExp(step.tail<3>());
    const Eigen::Vector4d q = quaternionProduct(quaternionFromMatrix(pose.R_wc), dq);
    return {rotationMatrix(normalizeQuaternion(q)), pose.r_wc + step.head<3>()};
}
}  // namespace

std::optional<std::vector<PointTerm>> pointTerms(const SeenPoints& seen, const Camera& camera,
                                                 const CameraPose& pose)
{
    std::vector<PointTerm> all;
    for (std::size_t i = 0; i < seen.points_m.size(); ++i)
    {
        const auto term = pointTerm(seen, i, camera, pose);
        if (!term) return std::nullopt;
        all.push_back(*term);
    }
    return all;
}

double chi2Of(const std::vector<PointTerm>& all)
{
    double sum = 0.0;
    for (const auto& term : all) sum += term.nu.dot(term.weight * term.nu);
    return sum;
}

Eigen::Matrix<double, 6, 6> informationOf(const std::vector<PointTerm>& all)
{
    Matrix6d A = Matrix6d::Zero();
    for (const auto& term : all) A += term.J_uv_pose.transpose() * term.weight * term.J_uv_pose;
    return A;
}

std::optional<CameraPose> refinePose(const SeenPoints& seen, const Camera& camera, CameraPose pose)
{
    auto all = pointTerms(seen, camera, pose);
    double lambda = 1e-4;
    for (int iteration = 0; all && iteration < 50; ++iteration)
    {
        Matrix6d A = informationOf(*all);
        A.diagonal() *= 1.0 + lambda;
        Vector6d b = Vector6d::Zero();
        for (const auto& term : *all) b += term.J_uv_pose.transpose() * term.weight * term.nu;
        const Vector6d step = A.ldlt().solve(b);
        if (!step.allFinite()) return std::nullopt;
        const CameraPose next = moved(pose, step);
        const auto nextTerms = pointTerms(seen, camera, next);
        const bool better = nextTerms && chi2Of(*nextTerms) <= chi2Of(*all) + 1e-12;
        lambda = better ? 0.1 * lambda : 10.0 * lambda;
        if (better)
        {
            pose = next;
            all = nextTerms;
        }
        if (lambda > 1e8 || (better && step.norm() < 1e-12)) break;
    }
    return all ? std::optional(pose) : std::nullopt;
}
}  // namespace monoslam
