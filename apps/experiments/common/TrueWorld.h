// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "DepthPictures.h"
#include "RenderedSequence.h"

namespace monoslam
{
/** What a patch of the birth image shows, by its depth. */
struct PatchDepth
{
    double variation = 0.0;  ///< (largest - least) / mean depth
    double bend = 0.0;       ///< largest relative distance from the plane that fits it best
};

/** Exact geometry of a rendered sequence: depth pictures and poses. */
class TrueWorld
{
   public:
    /** \param depthFolder  see DepthPictures */
    TrueWorld(const RenderedSequence& sequence, std::string depthFolder);

    /** The surface point that a pixel of one frame shows.
     *  \return nothing outside the image, without depth, or where no picture of it exists */
    [[nodiscard]] std::optional<Eigen::Vector3d> point(long frame, const Eigen::Vector2d& uv_px);
    [[nodiscard]] std::optional<Eigen::Vector2d> pixel(long frame,
                                                       const Eigen::Vector3d& p_w) const;
    [[nodiscard]] std::optional<PatchDepth> patchDepth(long frame, const Eigen::Vector2d& uv_px,
                                                       int half_px);
    /** True if something else stands before the point. */
    [[nodiscard]] bool isHidden(long frame, const Eigen::Vector3d& p_w);
    [[nodiscard]] Eigen::Vector3d eye(long frame) const;

   private:
    const RenderedSequence& sequence_;
    Camera camera_;
    DepthPictures depths_;
};
}  // namespace monoslam
