// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/Patch.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace monoslam
{
namespace
{
constexpr int kBlock = 16;
constexpr float kFixedPoint = 8.0F;

float bilinear(const cv::Mat& image, double u, double v)
{
    const int x = static_cast<int>(u);
    const int y = static_cast<int>(v);
    const auto a = static_cast<float>(u - x);
    const auto b = static_cast<float>(v - y);
    const auto* row = image.ptr<std::uint8_t>(y) + x;
    const auto* below = row + image.step[0];
    const float top = static_cast<float>(row[0]) * (1 - a) + static_cast<float>(row[1]) * a;
    const float low = static_cast<float>(below[0]) * (1 - a) + static_cast<float>(below[1]) * a;
    return top * (1 - b) + low * b;
}

/** Pyramid level whose pixels are about as large as one pixel now. */
int levelFor(const Eigen::Matrix2d& warp, int levels)
{
    const double scale = std::sqrt(std::abs(warp.determinant()));
    const int level = static_cast<int>(std::lround(std::log2(std::max(scale, 1.0))));
    return std::min(level, levels - 1);
}

bool inside(const cv::Mat& image, const Eigen::Vector2d& p)
{
    return p.x() >= 0.0 && p.y() >= 0.0 && p.x() < image.cols - 1.0 && p.y() < image.rows - 1.0;
}

bool sampleRing(const Appearance& born, const Eigen::Matrix2d& warp, Patch& patch)
{
    const int level = levelFor(warp, static_cast<int>(born.image->levels.size()));
    const cv::Mat& image = born.image->levels[static_cast<std::size_t>(level)];
    const double shrink = 1.0 / static_cast<double>(1 << level);
    const int reach = patch.half_px + 1;
    const Eigen::Vector2d centre = born.uv_px * shrink;
    const Eigen::Matrix2d step = warp * shrink;
    for (const int cx : {-reach, reach})
        for (const int cy : {-reach, reach})
            if (!inside(image, centre + step * Eigen::Vector2d(cx, cy))) return false;
    patch.grey.reserve(static_cast<std::size_t>((2 * reach + 1) * (2 * reach + 1)));
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
        {
            const Eigen::Vector2d p = centre + step * Eigen::Vector2d(dx, dy);
            patch.grey.push_back(bilinear(image, p.x(), p.y()));
        }
    return true;
}

/** Zero-mean fixed-point copy, rows padded with zeros to whole blocks. */
void centre(Patch& patch)
{
    const int side = patch.side();
    patch.stride = (side + kBlock - 1) / kBlock * kBlock;
    patch.centred.assign(static_cast<std::size_t>(patch.stride * side), 0);
    double sum = 0.0;
    for (int dy = -patch.half_px; dy <= patch.half_px; ++dy)
        for (int dx = -patch.half_px; dx <= patch.half_px; ++dx)
            sum += static_cast<double>(patch.at(dx, dy));
    const double mean = sum / (side * side);
    double squares = 0.0;
    patch.centredSum = 0.0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
        {
            const double value =
                static_cast<double>(patch.at(x - patch.half_px, y - patch.half_px)) - mean;
            const auto fixed = static_cast<std::int16_t>(std::lround(value * kFixedPoint));
            patch.centred[static_cast<std::size_t>(y * patch.stride + x)] = fixed;
            patch.centredSum += fixed;
            squares += static_cast<double>(fixed) * fixed;
        }
    patch.norm =
        std::sqrt(std::max(squares - patch.centredSum * patch.centredSum / (side * side), 0.0));
    patch.deviation = patch.norm / (kFixedPoint * side);
}
}  // namespace

std::optional<Patch> samplePatch(const Appearance& born, const PredictedWarp& warp, int half_px)
{
    Patch patch;
    patch.half_px = half_px;
    if (!sampleRing(born, warp.M, patch)) return std::nullopt;
    centre(patch);
    patch.slope = warp.slope;
    const Eigen::Matrix2d inverse = warp.M.inverse();
    for (std::size_t k = 0; k < 2; ++k) patch.stretch[k] = inverse * warp.J_M_s[k];
    return patch;
}
}  // namespace monoslam
