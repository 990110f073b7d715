// SPDX-License-Identifier: BSD-3-Clause
#include "DepthPictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <utility>

namespace monoslam
{
namespace
{
constexpr double kUnit_m = 1.0 / 5000.0;
constexpr double kOneSurface = 0.02;  ///< largest relative difference of depth within a pixel
constexpr std::size_t kMostPictures = 300;

struct Around
{
    std::array<double, 4> rho;     ///< [1/m]
    std::array<double, 4> weight;  ///< of linear interpolation
};

std::optional<Around> pixelsAround(const cv::Mat& depth, const Eigen::Vector2d& uv)
{
    const double x0 = std::floor(uv.x());
    const double y0 = std::floor(uv.y());
    if (!(x0 >= 0 && y0 >= 0 && x0 + 1 < depth.cols && y0 + 1 < depth.rows)) return std::nullopt;
    Around around{};
    for (const int k : {0, 1, 2, 3})
    {
        const int i = k % 2, j = k / 2;
        const auto value =
            depth.at<std::uint16_t>(static_cast<int>(y0) + j, static_cast<int>(x0) + i);
        if (value == 0) return std::nullopt;
        const auto at = static_cast<std::size_t>(k);
        around.rho[at] = 1.0 / (value * kUnit_m);
        around.weight[at] =
            (i == 1 ? uv.x() - x0 : 1.0 - uv.x() + x0) * (j == 1 ? uv.y() - y0 : 1.0 - uv.y() + y0);
    }
    return around;
}

double interpolated(const Around& around)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < around.rho.size(); ++k) sum += around.weight[k] * around.rho[k];
    return sum;
}
}  // namespace

DepthPictures::DepthPictures(std::string folder) : folder_(std::move(folder)) {}

const cv::Mat& DepthPictures::of(long frame)
{
    const auto known = pictures_.find(frame);
    if (known != pictures_.end()) return known->second;
    if (pictures_.size() > kMostPictures) pictures_.clear();
    char name[32];
    std::snprintf(name, sizeof name, "/%04ld.png", frame);
    const std::string file = folder_ + name;
    cv::Mat picture;
    if (std::filesystem::exists(file))
    {
        picture = cv::imread(file, cv::IMREAD_UNCHANGED);
        if (picture.type() != CV_16UC1)
            throw std::invalid_argument(file + ": no grey picture of 16 bit");
    }
    return pictures_[frame] = picture;
}

std::optional<double> inverseDepthAt(const cv::Mat& depth, const Eigen::Vector2d& uv)
{
    const auto around = pixelsAround(depth, uv);
    if (!around) return std::nullopt;
    return interpolated(*around);
}

std::optional<double> frontInverseDepthAt(const cv::Mat& depth, const Eigen::Vector2d& uv)
{
    const auto around = pixelsAround(depth, uv);
    if (!around) return std::nullopt;
    const auto [far, near] = std::minmax_element(around->rho.begin(), around->rho.end());
    return *near - *far < kOneSurface * *near ? interpolated(*around) : *near;
}
}  // namespace monoslam
