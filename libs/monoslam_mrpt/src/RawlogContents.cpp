// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/RawlogContents.h"

#include <mrpt/obs/CObservationRobotPose.h>

#include "monoslam_mrpt/ObservationStream.h"

namespace monoslam
{
RawlogContents scanRawlog(const std::string& file, StereoSide side)
{
    RawlogContents contents;
    ObservationStream stream(file);
    while (const auto observation = stream.next())
    {
        ++contents.classes[observation->GetRuntimeClass()->className];
        const Ticks t = ticksOf(observation->timestamp);
        if (imageOf(*observation, side)) contents.imageTimes[observation->sensorLabel].push_back(t);
        const auto* truth =
            dynamic_cast<const mrpt::obs::CObservationRobotPose*>(observation.get());
        if (truth != nullptr && truth->sensorLabel == "GT")
            contents.groundTruth.push_back({t, truth->pose.mean});
    }
    return contents;
}
}  // namespace monoslam
