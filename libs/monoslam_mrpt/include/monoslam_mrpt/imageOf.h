// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/img/CImage.h>
#include <mrpt/img/TCamera.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/poses/CPose3D.h>

#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>

#include "monoslam_mrpt/export.h"

namespace monoslam
{
enum class StereoSide
{
    Left,
    Right,
};

/** The image that an observation bears, with its camera. Points into the observation. */
struct RecordedImage
{
    const mrpt::img::CImage* image = nullptr;
    const mrpt::img::TCamera* camera = nullptr;
    mrpt::poses::CPose3D cameraPose;  ///< on the vehicle
};

/** \return nothing if the observation is not an image, of a stereo pair or a range camera either */
[[nodiscard]] MONOSLAM_MRPT_EXPORT std::optional<RecordedImage> imageOf(
    const mrpt::obs::CObservation& observation, StereoSide side);

/** An image file as 8-bit grey. \throw std::runtime_error naming the file if it is missing,
 *  truncated or no image */
[[nodiscard]] MONOSLAM_MRPT_EXPORT cv::Mat readGrey(const std::string& file);

/** Where the external images of a rawlog are: NAME_Images beside it, or Images. CRawlog's own search
 *  loses the slash after an absolute path. */
[[nodiscard]] MONOSLAM_MRPT_EXPORT std::string imagesFolderOf(const std::string& rawlogFile);

/** A recorded image as 8-bit grey; external ones are looked for in imagesFolder.
 *  \throw std::runtime_error if it cannot be decoded */
[[nodiscard]] MONOSLAM_MRPT_EXPORT cv::Mat toGrey(const mrpt::img::CImage& image,
                                                  const std::string& imagesFolder);
}  // namespace monoslam
