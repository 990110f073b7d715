// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/poses/CPose3D.h>

#include <map>
#include <string>
#include <vector>

#include "monoslam_mrpt/export.h"
#include "monoslam_mrpt/imageOf.h"
#include "monoslam_mrpt/timestamps.h"

namespace monoslam
{
/** A pose of the world's truth as the rawlog holds it. */
struct RecordedPose
{
    Ticks t = 0;
    mrpt::poses::CPose3D pose;
};

/** What one pass over a rawlog finds, without decoding external images. */
struct RawlogContents
{
    std::map<std::string, std::vector<Ticks>> imageTimes;  ///< of every label, in file order
    std::vector<RecordedPose> groundTruth;                 ///< CObservationRobotPose labelled GT
    std::map<std::string, long> classes;                   ///< observations of each class
    std::string damage;  ///< what ends the file early, naming it; empty if it is complete
};

/** \throw std::runtime_error naming the file if it is missing, no rawlog, or damaged before its
 *  first observation; damage after that is part of the result */
[[nodiscard]] MONOSLAM_MRPT_EXPORT RawlogContents scanRawlog(const std::string& file,
                                                             StereoSide side = StereoSide::Left);
}  // namespace monoslam
