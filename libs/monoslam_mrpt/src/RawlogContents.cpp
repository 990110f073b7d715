// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/RawlogContents.h"

#include <mrpt/obs/CObservationRobotPose.h>

#include <stdexcept>

#include "monoslam_mrpt/ObservationStream.h"

namespace monoslam
{
namespace
{
void add(const mrpt::obs::CObservation& observation, StereoSide side, RawlogContents& contents)
{
    ++contents.classes[observation.GetRuntimeClass()->className];
    const Ticks t = ticksOf(observation.timestamp);
    if (imageOf(observation, side)) contents.imageTimes[observation.sensorLabel].push_back(t);
    const auto* truth = dynamic_cast<const mrpt::obs::CObservationRobotPose*>(&observation);
    if (truth != nullptr && truth->sensorLabel == "GT")
        contents.groundTruth.push_back({t, truth->pose.mean});
}
}  // namespace

RawlogContents scanRawlog(const std::string& file, StereoSide side)
{
    RawlogContents contents;
    ObservationStream stream(file);
    try
    {
        while (const auto observation = stream.next()) add(*observation, side, contents);
    }
    catch (const std::runtime_error& e)
    {
        if (contents.classes.empty()) throw;
        contents.damage = e.what();
    }
    return contents;
}
}  // namespace monoslam
