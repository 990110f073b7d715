// SPDX-License-Identifier: BSD-3-Clause
#include "TrueWorld.h"

#include <Eigen/QR>
#include <cmath>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kUnit_m = 1.0 / 5000.0;
constexpr double kHidden = 0.02;  ///< relative difference of depth
constexpr std::size_t kMostPictures = 300;
}  // namespace

TrueWorld::TrueWorld(const RenderedSequence& sequence, std::string depthFolder)
    : sequence_(sequence), camera_(sequence.camera), depthFolder_(std::move(depthFolder))
{
}

const cv::Mat& TrueWorld::depth(long frame)
{
    const auto known = depths_.find(frame);
    if (known != depths_.end()) return known->second;
    if (depths_.size() > kMostPictures) depths_.clear();
    char name[32];
    std::snprintf(name, sizeof name, "/%04ld.png", frame);
    return depths_[frame] = cv::imread(depthFolder_ + name, cv::IMREAD_UNCHANGED);
}

/** Linear between pixel centres, which is exact on a plane. */
std::optional<double> TrueWorld::inverseDepth(long frame, const Eigen::Vector2d& uv)
{
    const cv::Mat& picture = depth(frame);
    const int x = static_cast<int>(std::floor(uv.x()));
    const int y = static_cast<int>(std::floor(uv.y()));
    if (x < 0 || y < 0 || x + 1 >= picture.cols || y + 1 >= picture.rows) return std::nullopt;
    double sum = 0.0;
    for (const int j : {0, 1})
        for (const int i : {0, 1})
        {
            const auto value = picture.at<std::uint16_t>(y + j, x + i);
            if (value == 0) return std::nullopt;
            const double a = i == 1 ? uv.x() - x : 1.0 - uv.x() + x;
            const double b = j == 1 ? uv.y() - y : 1.0 - uv.y() + y;
            sum += a * b / (value * kUnit_m);
        }
    return sum;
}

std::optional<Eigen::Vector3d> TrueWorld::point(long frame, const Eigen::Vector2d& uv)
{
    const auto rho = inverseDepth(frame, uv);
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
            const auto value = inverseDepth(frame, uv + Eigen::Vector2d(dx, dy));
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
