// SPDX-License-Identifier: BSD-3-Clause
#include "EllipseScores.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace monoslam
{
namespace
{
/** Integer pixels of the ellipse's bounding box around which the whole patch fits. */
cv::Rect boundingBox(const PreparedImage& image, const Patch& patch,
                     const PatchSearchRegion& region)
{
    const int margin = patch.half_px;
    const double reachU = std::sqrt(region.gate * region.S(0, 0));
    const double reachV = std::sqrt(region.gate * region.S(1, 1));
    const auto low = [margin](double value)
    { return std::max(margin, static_cast<int>(std::ceil(std::max(value, 0.0)))); };
    const auto high = [margin](double value, int size)
    { return static_cast<int>(std::floor(std::min(value, size - 1.0 - margin))); };
    const int left = low(region.centre_px.x() - reachU);
    const int top = low(region.centre_px.y() - reachV);
    const int width = high(region.centre_px.x() + reachU, image.width_px) - left + 1;
    const int height = high(region.centre_px.y() + reachV, image.height_px) - top + 1;
    return {left, top, std::max(width, 0), std::max(height, 0)};
}
}  // namespace

EllipseScores::EllipseScores(const PreparedImage& image, const Patch& patch,
                             const PatchSearchRegion& region)
    : image_(image),
      patch_(patch),
      region_(region),
      information_(region.S.inverse()),
      box_(boundingBox(image, patch, region)),
      scores_(static_cast<std::size_t>(box_.width) * static_cast<std::size_t>(box_.height),
              kUnknown)
{
}

void EllipseScores::fill(int step)
{
    forEvery(step, [this](int u, int v) { score(u, v); });
}

void EllipseScores::score(int u, int v)
{
    if (!covers(u, v) || scores_[index(u, v)] > kUnknown) return;
    const Eigen::Vector2d d = Eigen::Vector2d(u, v) - region_.centre_px;
    if (d.dot(information_ * d) >= region_.gate) return;
    scores_[index(u, v)] = static_cast<float>(correlate(image_, patch_, u, v));
    ++pixels_;
}

bool EllipseScores::isPeak(int u, int v, int step) const
{
    const float score = at(u, v);
    for (int dv = -1; dv <= 1; ++dv)
        for (int du = -1; du <= 1; ++du)
        {
            if (du == 0 && dv == 0) continue;
            const float other = at(u + step * du, v + step * dv);
            const bool earlier = dv < 0 || (dv == 0 && du < 0);
            if (other > score || (earlier && other == score)) return false;
        }
    return true;
}

cv::Point EllipseScores::climb(cv::Point from)
{
    cv::Point top = from;
    do
    {
        from = top;
        for (int dv = -1; dv <= 1; ++dv)
            for (int du = -1; du <= 1; ++du)
            {
                score(from.x + du, from.y + dv);
                if (at(from.x + du, from.y + dv) > at(top.x, top.y))
                    top = {from.x + du, from.y + dv};
            }
    } while (top != from);
    return top;
}
}  // namespace monoslam
