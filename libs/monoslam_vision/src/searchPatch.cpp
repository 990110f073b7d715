// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/searchPatch.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "EllipseScores.h"

namespace monoslam
{
namespace
{
/** Variance times n below which a window counts as flat [grey levels^2]. */
constexpr double kFlat = 1e-3;
constexpr float kUnknown = -2.0F;         ///< score of a pixel that was not looked at
constexpr double kSmallArea_px2 = 500.0;  ///< of an ellipse in which every pixel is scored
constexpr double kStandsOut = 0.4;        ///< below the least score, and still worth a climb

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

std::vector<CorrelationPeak> allPeaks(EllipseScores& scores, double minScore)
{
    scores.fill(1);
    std::vector<CorrelationPeak> peaks;
    scores.forEvery(1,
                    [&](int u, int v)
                    {
                        const auto score = static_cast<double>(scores.at(u, v));
                        if (score >= minScore && scores.isPeak(u, v, 1))
                            peaks.push_back({Eigen::Vector2d(u, v), score});
                    });
    return peaks;
}

/** Every other pixel, then uphill from each that stands out: smoothed patches still correlate two
 *  pixels off. */
std::vector<CorrelationPeak> climbedPeaks(EllipseScores& scores, double minScore)
{
    scores.fill(2);
    std::vector<cv::Point> starts;
    scores.forEvery(2,
                    [&](int u, int v)
                    {
                        const auto score = static_cast<double>(scores.at(u, v));
                        if (score >= minScore - kStandsOut && scores.isPeak(u, v, 2))
                            starts.emplace_back(u, v);
                    });
    std::vector<CorrelationPeak> peaks;
    for (const cv::Point& start : starts)
    {
        const cv::Point top = scores.climb(start);
        const Eigen::Vector2d uv(top.x, top.y);
        const bool known =
            std::any_of(peaks.begin(), peaks.end(),
                        [&](const CorrelationPeak& other) { return other.uv_px == uv; });
        const auto score = static_cast<double>(scores.at(top.x, top.y));
        if (score >= minScore && !known) peaks.push_back({uv, score});
    }
    return peaks;
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
    EllipseScores scores(image, patch, region);
    const double area_px2 = M_PI * region.gate * std::sqrt(region.S.determinant());
    PatchSearch result;
    result.peaks = area_px2 <= kSmallArea_px2 ? allPeaks(scores, region.minScore)
                                              : climbedPeaks(scores, region.minScore);
    result.pixels = scores.pixels();
    keepSeparate(result.peaks, region);
    return result;
}
}  // namespace monoslam
