// SPDX-License-Identifier: BSD-3-Clause
#include "LandmarkTruth.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kSameTime_s = 1e-3;
constexpr long kNearestPicture = 10;    ///< frames
constexpr double kLargestRho_1pm = 10;  ///< the ray is followed from 0.1 m on
constexpr int kSteps = 400;             ///< below a pixel each for a tenth of a metre of baseline
constexpr int kBisections = 30;
constexpr double kOnSurface = 1e-3;  ///< of the depth

Eigen::Vector3d onRay(const StampedPose& from, const Eigen::Vector3d& ray_c, double rho)
{
    return rotationMatrix(from.q_wc) * (ray_c / rho) + from.r_wc;
}
}  // namespace

LandmarkTruth::LandmarkTruth(Trajectory truth, const CameraParameters& camera,
                             const std::string& depthFolder)
    : truth_(std::move(truth)), camera_(camera), depths_(depthFolder)
{
    if (!std::filesystem::is_directory(depthFolder))
        throw std::invalid_argument(depthFolder + ": no such folder");
}

std::optional<TruePoint> LandmarkTruth::point(double t_s, const Eigen::Vector2d& uv)
{
    const auto pose = std::lower_bound(truth_.begin(), truth_.end(), t_s - kSameTime_s,
                                       [](const StampedPose& p, double t) { return p.t_s < t; });
    const auto ray = camera_.unproject(uv);
    if (pose == truth_.end() || pose->t_s > t_s + kSameTime_s || !ray) return std::nullopt;
    const auto p_w = pointOn(*ray, uv, pose - truth_.begin());
    if (!p_w) return std::nullopt;
    return TruePoint{*p_w, (*p_w - pose->r_wc).norm()};
}

std::optional<Eigen::Vector3d> LandmarkTruth::pointOn(const Eigen::Vector3d& ray_c,
                                                      const Eigen::Vector2d& uv, long frame)
{
    const StampedPose& pose = truth_[static_cast<std::size_t>(frame)];
    if (const cv::Mat& own = depths_.of(frame); !own.empty())
    {
        const auto rho = frontInverseDepthAt(own, uv);
        if (!rho) return std::nullopt;
        return onRay(pose, ray_c, *rho);
    }
    for (long away = 1; away <= kNearestPicture; ++away)
        for (const long other : {frame - away, frame + away})
            if (other >= 0 && other < static_cast<long>(truth_.size()) &&
                !depths_.of(other).empty())
                return meet(pose, ray_c, other);
    return std::nullopt;
}

std::optional<double> LandmarkTruth::behind(const Eigen::Vector3d& p_w, long picture)
{
    const StampedPose& pose = truth_[static_cast<std::size_t>(picture)];
    const Eigen::Vector3d p_c = rotateInverse(pose.q_wc, p_w - pose.r_wc);
    const auto uv = camera_.project(p_c);
    const auto rho = uv ? frontInverseDepthAt(depths_.of(picture), *uv) : std::nullopt;
    if (!rho) return std::nullopt;
    return p_c.z() * *rho - 1.0;
}

std::optional<Eigen::Vector3d> LandmarkTruth::meet(const StampedPose& from,
                                                   const Eigen::Vector3d& ray_c, long picture)
{
    double front = 0.0;  // inverse depth of the last point before the surface
    for (int step = kSteps; step >= 1; --step)
    {
        double back = kLargestRho_1pm * step / kSteps;
        const auto b = behind(onRay(from, ray_c, back), picture);
        if (!b) continue;
        if (*b < 0.0)
        {
            front = back;
            continue;
        }
        if (front == 0.0) return std::nullopt;  // what lies before it is out of view
        for (int i = 0; i < kBisections; ++i)
        {
            const double middle = 0.5 * (front + back);
            const auto m = behind(onRay(from, ray_c, middle), picture);
            if (!m) return std::nullopt;
            (*m < 0.0 ? front : back) = middle;
        }
        const Eigen::Vector3d p_w = onRay(from, ray_c, back);
        const auto left = behind(p_w, picture);
        if (!left || *left > kOnSurface) return std::nullopt;  // went behind what the picture shows
        return p_w;
    }
    return std::nullopt;
}
}  // namespace monoslam
