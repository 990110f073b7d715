// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/readFeatureRawlog.h"

#include <mrpt/obs/CObservationRobotPose.h>

#include <stdexcept>

#include "monoslam_mrpt/CObservationPixelFeatures.h"
#include "monoslam_mrpt/ObservationStream.h"

namespace monoslam
{
namespace
{
void append(const CObservationPixelFeatures& observation, const std::string& file,
            FeatureRawlog& rawlog)
{
    const auto fail = [&](const char* message)
    {
        throw std::runtime_error(file + ": frame " + std::to_string(rawlog.frames.size()) + ": " +
                                 message);
    };
    const double t_s = seconds(ticksOf(observation.timestamp));
    if (rawlog.frames.empty()) rawlog.camera = observation.cameraParams;
    if (!(rawlog.camera == observation.cameraParams)) fail("is of another camera than the first");
    if (!rawlog.frames.empty() && t_s <= rawlog.frames.back().t_s)
        fail("its time is not after that of the frame before it");
    rawlog.frames.push_back({t_s, observation.features});
}
}  // namespace

FeatureRawlog readFeatureRawlog(const std::string& file)
{
    FeatureRawlog rawlog;
    ObservationStream stream(file);
    while (const auto observation = stream.next())
    {
        if (const auto* frame = dynamic_cast<const CObservationPixelFeatures*>(observation.get()))
            append(*frame, file, rawlog);
        const auto* truth =
            dynamic_cast<const mrpt::obs::CObservationRobotPose*>(observation.get());
        if (truth != nullptr && truth->sensorLabel == "GT")
            rawlog.groundTruth.push_back({ticksOf(truth->timestamp), truth->pose.mean});
    }
    if (rawlog.frames.empty())
        throw std::runtime_error(file + ": there are no CObservationPixelFeatures in it");
    return rawlog;
}
}  // namespace monoslam
