// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monoslam_eval/PixelFeatures.h"
#include "monoslam_mrpt/RawlogContents.h"
#include "monoslam_mrpt/cameraFrom.h"
#include "monoslam_mrpt/export.h"

namespace monoslam
{
/** All CObservationPixelFeatures of a rawlog. */
struct FeatureRawlog
{
    mrpt::img::TCamera camera;  ///< of the first
    std::vector<PixelFrame> frames;
    std::vector<RecordedPose> groundTruth;  ///< CObservationRobotPose labelled GT
};

/** \throw std::runtime_error naming the file, and the frame where there is one: missing, damaged,
 *  without features, time not increasing, or several cameras */
[[nodiscard]] MONOSLAM_MRPT_EXPORT FeatureRawlog readFeatureRawlog(const std::string& file);
}  // namespace monoslam
