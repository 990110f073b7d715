// SPDX-License-Identifier: BSD-3-Clause
#include "TrueWorld.h"

#include <Eigen/QR>
#include <cmath>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kHidden = 0.02;  ///< relative difference of depth
}  // namespace

TrueWorld::TrueWorld(const RenderedSequence& sequence, std::string depthFolder)
    : sequence_(sequence), camera_(sequence.camera), depths_(std::move(depthFolder))
{
}

std::optional<Eigen::Vector3d> TrueWorld::point(long frame, const Eigen::Vector2d& uv)
{
    const auto rho = inverseDepthAt(depths_.of(frame), uv);
    const auto ray = camera_.unproject(uv);
    if (!rho || !ray) return std::nullopt;
    const Vector7d& pose = sequence_.poses[static_cast<std::size_t>(frame)];
    const Eigen::Vector3d p_c = *ray / *rho;
    return Eigen::Vector3d(rotationMatrix(pose.tail<4>()) * p_c + pose.head<3>());
}

std::optional<Eigen::Vector2d> TrueWorld::pixel(long frame, const Eigen::Vector3d& p_w) const
{
    const Vector7d& pose = sequence_.poses[static_cast<std::size_t>(frame)];
    return camera_.project(rotationMatrix(pose.tail<4>()).transpose() * (p_w - pose.head<3>()));
}

Eigen::Vector3d TrueWorld::eye(long frame) const
{
    return sequence_.poses[static_cast<std::size_t>(frame)].head<3>();
}

bool TrueWorld::isHidden(long frame, const Eigen::Vector3d& p_w)
{
    const auto uv = pixel(frame, p_w);
    const auto seen = uv ? point(frame, *uv) : std::nullopt;
    if (!seen) return false;
    const Eigen::Vector3d from = eye(frame);
    return (*seen - from).norm() < (1.0 - kHidden) * (p_w - from).norm();
}

std::optional<PatchDepth> TrueWorld::patchDepth(long frame, const Eigen::Vector2d& uv, int half)
{
    const int side = 2 * half + 1;
    Eigen::MatrixXd A(side * side, 3);
    Eigen::VectorXd rho(side * side);
    Eigen::Index row = 0;
    for (int dy = -half; dy <= half; ++dy)
        for (int dx = -half; dx <= half; ++dx, ++row)
        {
            const auto value = inverseDepthAt(depths_.of(frame), uv + Eigen::Vector2d(dx, dy));
            if (!value) return std::nullopt;
            A.row(row) << dx, dy, 1.0;
            rho(row) = *value;
        }
    const Eigen::Vector3d plane = A.colPivHouseholderQr().solve(rho);
    PatchDepth result;
    result.bend = ((rho - A * plane).cwiseAbs().maxCoeff()) / rho.mean();
    result.variation =
        rho.cwiseInverse().maxCoeff() * rho.mean() - rho.cwiseInverse().minCoeff() * rho.mean();
    return result;
}
}  // namespace monoslam
