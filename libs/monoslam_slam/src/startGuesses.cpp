// SPDX-License-Identifier: BSD-3-Clause
#include "startGuesses.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr std::size_t kLeastCommon = 12;
constexpr double kThreshold_px = 1.5;
constexpr double kConfidence = 0.999;
constexpr double kLeastDepth = 0.1;  ///< relative to the median
constexpr double kMostDepth = 20.0;

struct CommonPixels
{
    std::vector<std::size_t> landmarks;
    std::vector<cv::Point2d> first;  ///< normalised
    std::vector<cv::Point2d> last;
};

double medianRho(const Window& window)
{
    std::vector<double> rhos;
    for (const auto& landmark : window.landmarks)
        if (landmark.kind == LandmarkKind::InverseDepth)
            rhos.push_back(landmark.y(inverse_depth::kRho));
    if (rhos.empty()) return 1.0;
    const auto middle = rhos.begin() + static_cast<std::ptrdiff_t>(rhos.size() / 2);
    std::nth_element(rhos.begin(), middle, rhos.end());
    return *middle;
}

void setRho(Window& window, double rho)
{
    for (auto& landmark : window.landmarks)
        if (landmark.kind == LandmarkKind::InverseDepth) landmark.y(inverse_depth::kRho) = rho;
}

CommonPixels commonPixels(const Window& window, const Camera& camera)
{
    const auto last = static_cast<Eigen::Index>(window.poses.size()) - 1;
    std::map<Eigen::Index, Eigen::Vector3d> firstRays;
    for (const auto& seen : window.observations)
        if (seen.view == 0)
            if (const auto ray = camera.unproject(seen.z)) firstRays[seen.landmark] = *ray;
    CommonPixels common;
    for (const auto& seen : window.observations)
    {
        const auto first = firstRays.find(seen.landmark);
        if (seen.view != last || first == firstRays.end()) continue;
        const auto ray = camera.unproject(seen.z);
        if (!ray) continue;
        common.landmarks.push_back(static_cast<std::size_t>(seen.landmark));
        common.first.emplace_back(first->second.x(), first->second.y());
        common.last.emplace_back(ray->x(), ray->y());
    }
    return common;
}

/** Depth in the first camera of the point where two rays come closest; x_last = R x_first + t. */
double intersect(const cv::Point2d& first, const cv::Point2d& last, const Eigen::Matrix3d& R,
                 const Eigen::Vector3d& t)
{
    const Eigen::Vector3d a = R * Eigen::Vector3d(first.x, first.y, 1.0);
    const Eigen::Vector3d b(last.x, last.y, 1.0);
    const Eigen::Vector3d n = a.cross(b);
    return -n.dot(t.cross(b)) / std::max(n.squaredNorm(), 1e-12);
}

/** Poses between the first and the last one, linear in position and along the geodesic in angle. */
void interpolatePoses(Window& window, const Vector7d& last)
{
    const Vector7d first = window.poses.front();
    const Eigen::Vector3d turn =
        quaternionLog(quaternionProduct(quaternionConjugate(first.tail<4>()), last.tail<4>()));
    for (std::size_t k = 0; k < window.poses.size(); ++k)
    {
        const double part = static_cast<double>(k) / static_cast<double>(window.poses.size() - 1);
        window.poses[k].head<3>() = (1.0 - part) * first.head<3>() + part * last.head<3>();
        window.poses[k].tail<4>() =
            normalizeQuaternion(quaternionProduct(first.tail<4>(), quaternionExp(part * turn)));
    }
}
}  // namespace

Window flatGuess(Window window)
{
    setRho(window, medianRho(window));
    const Vector7d first = window.poses.front();
    for (auto& pose : window.poses) pose = first;
    return window;
}

std::optional<Window> twoViewGuess(Window window, const Camera& camera)
{
    const CommonPixels common = commonPixels(window, camera);
    if (common.landmarks.size() < kLeastCommon) return std::nullopt;
    cv::Mat mask;
    cv::setRNGSeed(1);  // RANSAC of OpenCV draws from its global generator
    const cv::Mat E =
        cv::findEssentialMat(common.first, common.last, cv::Mat::eye(3, 3, CV_64F), cv::RANSAC,
                             kConfidence, kThreshold_px / camera.parameters().fx_px, mask);
    if (E.rows != 3 || E.cols != 3) return std::nullopt;
    cv::Mat R_cv;
    cv::Mat t_cv;
    cv::recoverPose(E, common.first, common.last, cv::Mat::eye(3, 3, CV_64F), R_cv, t_cv, mask);
    Eigen::Matrix3d R;
    Eigen::Vector3d t;
    cv::cv2eigen(R_cv, R);
    cv::cv2eigen(t_cv, t);

    std::vector<double> depths;
    for (std::size_t i = 0; i < common.landmarks.size(); ++i)
        depths.push_back(intersect(common.first[i], common.last[i], R, t));
    std::vector<double> sorted = depths;
    std::nth_element(sorted.begin(),
                     sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
    const double median = sorted[sorted.size() / 2];
    if (!(median > 0.0)) return std::nullopt;

    const double rho = medianRho(window);
    const double unit = 1.0 / (rho * median);
    setRho(window, rho);
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
        WindowLandmark& landmark = window.landmarks[common.landmarks[i]];
        if (landmark.kind != LandmarkKind::InverseDepth) continue;
        const double depth =
            std::clamp(depths[i], kLeastDepth * median, kMostDepth * median) * unit;
        const double length = std::hypot(common.first[i].x, common.first[i].y, 1.0);
        landmark.y(inverse_depth::kRho) = 1.0 / (depth * length);
    }
    const Vector7d first = window.poses.front();
    const Eigen::Matrix3d R_w0 = rotationMatrix(first.tail<4>());
    Vector7d last;
    last.head<3>() = first.head<3>() - unit * (R_w0 * (R.transpose() * t));
    last.tail<4>() = quaternionFromMatrix(R_w0 * R.transpose());
    interpolatePoses(window, last);
    return window;
}
}  // namespace monoslam
