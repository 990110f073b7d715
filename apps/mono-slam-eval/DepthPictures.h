// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <map>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>

namespace monoslam
{
/** Depth of a sequence's frames, read when they are asked for. */
class DepthPictures
{
   public:
    /** \param folder  of NNNN.png: 16 bit, z-depth at the pixel centre times 5000 per metre, 0 where
     *  there is none (TUM) */
    explicit DepthPictures(std::string folder);

    /** \return an empty picture where there is no file
     *  \throw std::invalid_argument naming a file that is no 16-bit picture */
    [[nodiscard]] const cv::Mat& of(long frame);

   private:
    std::string folder_;
    std::map<long, cv::Mat> pictures_;
};

/** 1 / z [1/m] at a pixel: linear between pixel centres, which is exact on a plane.
 *  \return nothing outside the picture or next to a pixel without depth */
[[nodiscard]] std::optional<double> inverseDepthAt(const cv::Mat& depth,
                                                   const Eigen::Vector2d& uv_px);

/** The same, but where the four pixels around belong to more than one surface the nearest of them:
 *  an edge that a corner lies on is that of the surface in front. */
[[nodiscard]] std::optional<double> frontInverseDepthAt(const cv::Mat& depth,
                                                        const Eigen::Vector2d& uv_px);
}  // namespace monoslam
