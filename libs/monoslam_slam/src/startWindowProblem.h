// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "LandmarkRecord.h"
#include "monoslam_filter/smoothWindow.h"
#include "monoslam_slam/StartOptions.h"

namespace monoslam
{
/** A landmark's pixel in one view. */
struct StartPixel
{
    LandmarkId id = -1;
    Eigen::Vector2d z;
    Eigen::Matrix2d R;
};

/** What is kept of one frame of the first seconds. */
struct StartView
{
    double t_s = 0.0;
    Vector7d pose;
    std::vector<StartPixel> pixels;
};

/** A window and the landmark of each of its entries. */
struct StartWindowProblem
{
    Window window;
    std::vector<LandmarkId> ids;
};

/** At most \p wanted indices, evenly spaced, the last two views among them. */
[[nodiscard]] std::vector<std::size_t> selectViews(std::size_t available, int wanted);

/** Poses, landmarks seen often enough and their pixels, from the belief's guess. What fixes the
 *  world: nearly nothing but the known points if \p metric, else the first pose and the length. */
[[nodiscard]] StartWindowProblem startWindowProblem(const std::vector<const StartView*>& views,
                                                    const Belief& belief,
                                                    const LandmarkRecords& records,
                                                    const StartOptions& options, bool metric);

/** Landmarks of a smoothed window that lie in front and explain enough of their pixels. */
[[nodiscard]] std::vector<bool> trusted(const Window& window, const SmoothedWindow& smoothed,
                                        const StartOptions& options);
}  // namespace monoslam
