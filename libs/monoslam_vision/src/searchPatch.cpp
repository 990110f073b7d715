// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/searchPatch.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace monoslam
{
namespace
{
/** Variance times n below which a window counts as flat [grey levels^2]. */
constexpr double kFlat = 1e-3;

template <int Stride>
int productSum(const std::int16_t* patch, const std::uint8_t* image, std::size_t step, int rows)
{
    int sum = 0;
    for (int row = 0; row < rows; ++row, patch += Stride, image += step)
        for (int column = 0; column < Stride; ++column)
            sum += static_cast<int>(patch[column]) * static_cast<std::int16_t>(image[column]);
    return sum;
}

double crossSum(const PreparedImage& image, const Patch& patch, int left, int top)
{
    const cv::Mat& base = image.levels.front();
    const auto* pixels = base.ptr<std::uint8_t>(top) + left;
    if (patch.stride == 16)
        return productSum<16>(patch.centred.data(), pixels, base.step[0], patch.side());
    return productSum<32>(patch.centred.data(), pixels, base.step[0], patch.side());
}

template <typename T>
double boxSum(const cv::Mat& integral, int left, int top, int side)
{
    const auto* a = integral.ptr<T>(top);
    const auto* b = integral.ptr<T>(top + side);
    return static_cast<double>(b[left + side] - b[left] - a[left + side] + a[left]);
}

/** Rectangle of integer pixels with one score each. */
struct ScoreMap
{
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
    std::vector<float> scores;

    [[nodiscard]] float at(int u, int v) const
    {
        if (u < left || v < top || u >= left + width || v >= top + height) return -1.0F;
        return scores[static_cast<std::size_t>((v - top) * width + u - left)];
    }
};

ScoreMap boundingBox(const PreparedImage& image, const Patch& patch,
                     const PatchSearchRegion& region)
{
    const int margin = patch.half_px;
    const double reachU = std::sqrt(region.gate * region.S(0, 0));
    const double reachV = std::sqrt(region.gate * region.S(1, 1));
    const auto low = [margin](double value)
    { return std::max(margin, static_cast<int>(std::ceil(std::max(value, 0.0)))); };
    const auto high = [margin](double value, int size)
    { return static_cast<int>(std::floor(std::min(value, size - 1.0 - margin))); };
    ScoreMap map;
    map.left = low(region.centre_px.x() - reachU);
    map.top = low(region.centre_px.y() - reachV);
    map.width = high(region.centre_px.x() + reachU, image.width_px) - map.left + 1;
    map.height = high(region.centre_px.y() + reachV, image.height_px) - map.top + 1;
    map.width = std::max(map.width, 0);
    map.height = std::max(map.height, 0);
    map.scores.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height),
                      -1.0F);
    return map;
}

long fillEllipse(const PreparedImage& image, const Patch& patch, const PatchSearchRegion& region,
                 ScoreMap& map)
{
    const Eigen::Matrix2d information = region.S.inverse();
    long pixels = 0;
    for (int v = map.top; v < map.top + map.height; ++v)
        for (int u = map.left; u < map.left + map.width; ++u)
        {
            const Eigen::Vector2d d = Eigen::Vector2d(u, v) - region.centre_px;
            if (d.dot(information * d) >= region.gate) continue;
            const auto at = static_cast<std::size_t>((v - map.top) * map.width + u - map.left);
            map.scores[at] = static_cast<float>(correlate(image, patch, u, v));
            ++pixels;
        }
    return pixels;
}

bool isPeak(const ScoreMap& map, int u, int v)
{
    const float score = map.at(u, v);
    for (int dv = -1; dv <= 1; ++dv)
        for (int du = -1; du <= 1; ++du)
        {
            if (du == 0 && dv == 0) continue;
            const float other = map.at(u + du, v + dv);
            const bool earlier = dv < 0 || (dv == 0 && du < 0);
            if (other > score || (earlier && other == score)) return false;
        }
    return true;
}

void keepSeparate(std::vector<CorrelationPeak>& peaks, const PatchSearchRegion& region)
{
    std::stable_sort(peaks.begin(), peaks.end(),
                     [](const CorrelationPeak& a, const CorrelationPeak& b)
                     { return a.score > b.score; });
    std::vector<CorrelationPeak> kept;
    for (const auto& peak : peaks)
    {
        if (static_cast<int>(kept.size()) >= region.maxPeaks) break;
        const bool separate =
            std::none_of(kept.begin(), kept.end(),
                         [&](const CorrelationPeak& other)
                         { return (other.uv_px - peak.uv_px).norm() < region.peakDistance_px; });
        if (separate) kept.push_back(peak);
    }
    peaks = std::move(kept);
}
}  // namespace

double correlate(const PreparedImage& image, const Patch& patch, int u, int v)
{
    const int left = u - patch.half_px;
    const int top = v - patch.half_px;
    const int side = patch.side();
    if (left < 0 || top < 0 || left + side > image.width_px || top + side > image.height_px)
        return -1.0;
    const double sum = boxSum<int>(image.sum, left, top, side);
    const double squares = boxSum<double>(image.squareSum, left, top, side);
    const double spread = squares - sum * sum / (side * side);
    if (spread < kFlat || patch.norm <= 0.0) return -1.0;
    const double cross = crossSum(image, patch, left, top) - patch.centredSum * sum / (side * side);
    return cross / (patch.norm * std::sqrt(spread));
}

PatchSearch searchPatch(const PreparedImage& image, const Patch& patch,
                        const PatchSearchRegion& region)
{
    PatchSearch result;
    ScoreMap map = boundingBox(image, patch, region);
    result.pixels = fillEllipse(image, patch, region, map);
    for (int v = map.top; v < map.top + map.height; ++v)
        for (int u = map.left; u < map.left + map.width; ++u)
            if (map.at(u, v) >= region.minScore && isPeak(map, u, v))
                result.peaks.push_back({Eigen::Vector2d(u, v), static_cast<double>(map.at(u, v))});
    keepSeparate(result.peaks, region);
    return result;
}
}  // namespace monoslam
