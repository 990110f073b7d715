// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <opencv2/core.hpp>
#include <vector>

#include "monoslam_vision/Patch.h"
#include "monoslam_vision/PreparedImage.h"
#include "monoslam_vision/searchPatch.h"

namespace monoslam
{
/** ZNCC of a patch at the integer pixels of an ellipse, computed where it is asked for. */
class EllipseScores
{
   public:
    /** Keeps references to all three. */
    EllipseScores(const PreparedImage& image, const Patch& patch, const PatchSearchRegion& region);

    /** Scores every step-th pixel in both directions. */
    void fill(int step);

    /** Score of a pixel; -2 outside the ellipse and where nothing was asked for. */
    [[nodiscard]] float at(int u, int v) const
    {
        return covers(u, v) ? scores_[index(u, v)] : kUnknown;
    }

    /** Not lower than its neighbours step pixels away; the first of equals. */
    [[nodiscard]] bool isPeak(int u, int v, int step) const;

    /** The local maximum uphill from a pixel; all its neighbours are scored then. */
    [[nodiscard]] cv::Point climb(cv::Point from);

    /** Pixels scored so far. */
    [[nodiscard]] long pixels() const { return pixels_; }

    /** Calls f(u, v) on every step-th pixel of the bounding box. */
    template <typename Function>
    void forEvery(int step, const Function& f) const
    {
        for (int v = box_.y; v < box_.y + box_.height; v += step)
            for (int u = box_.x; u < box_.x + box_.width; u += step) f(u, v);
    }

   private:
    static constexpr float kUnknown = -2.0F;

    [[nodiscard]] bool covers(int u, int v) const { return box_.contains(cv::Point(u, v)); }
    [[nodiscard]] std::size_t index(int u, int v) const
    {
        return static_cast<std::size_t>((v - box_.y) * box_.width + u - box_.x);
    }
    void score(int u, int v);

    const PreparedImage& image_;
    const Patch& patch_;
    const PatchSearchRegion& region_;
    Eigen::Matrix2d information_;
    cv::Rect box_;
    std::vector<float> scores_;
    long pixels_ = 0;
};
}  // namespace monoslam
