// SPDX-License-Identifier: BSD-3-Clause
#include <mrpt/poses/CPose3DQuat.h>

#include <algorithm>
#include <cstdio>

#include "monoslam_eval/PairCounts.h"
#include "monoslam_eval/metrics.h"
#include "monoslam_mrpt/readFeatureRawlog.h"
#include "monoslam_slam/writers.h"
#include "run.h"

namespace monoslam
{
namespace
{
StampedPose stamped(double t_s, const Vector7d& pose)
{
    return {t_s, pose.head<3>(), pose.tail<4>()};
}

Trajectory truthOf(const FeatureRawlog& rawlog)
{
    Trajectory truth;
    for (const RecordedPose& recorded : rawlog.groundTruth)
    {
        const mrpt::poses::CPose3DQuat p(recorded.pose);
        Vector7d pose;
        pose << p.x(), p.y(), p.z(), p.quat().r(), p.quat().x(), p.quat().y(), p.quat().z();
        truth.push_back(stamped(seconds(recorded.t), pose));
    }
    return truth;
}

/** As the writers of mono-slam want it. */
FrameReport toFrameReport(FeatureReport report, long index)
{
    FrameReport frame;
    frame.t_s = report.t_s;
    frame.index = index;
    frame.state = TrackingState::Tracking;
    frame.x_v = report.x_v;
    frame.P_v = report.P_v;
    frame.landmarks = report.landmarks;
    frame.visible = static_cast<int>(report.associations.size());
    frame.matched = static_cast<int>(
        std::count_if(report.associations.begin(), report.associations.end(),
                      [](const Association& pair) { return pair.fate == Fate::Matched; }));
    frame.counters = report.counters;
    frame.diversity = report.diversity;
    frame.times.search_ms = report.counters.searchMs;
    frame.times.associate_ms = report.counters.selectMs;
    frame.times.update_ms = report.counters.updateMs;
    frame.times.total_ms =
        report.counters.searchMs + report.counters.selectMs + report.counters.updateMs;
    frame.associations = std::move(report.associations);
    return frame;
}

void printFigures(const Trajectory& path, const Trajectory& truth, const PairCounts& pairs)
{
    std::printf("%zu frames; %ld right and %ld wrong pairs, precision %.4f, recall %.4f\n",
                path.size(), pairs.right, pairs.wrong, pairs.precision(), pairs.recall());
    if (truth.empty()) return;
    const TrajectoryErrors errors = trajectoryErrors(matchByTime(path, truth), Alignment::None);
    std::printf("position error without alignment: rmse %.3f mm, largest %.3f mm\n",
                1e3 * errors.position_m.rmse, 1e3 * errors.position_m.max);
}
}  // namespace

void runStrategy(const Arguments& arguments, const Config& config)
{
    const FeatureRawlog rawlog = readFeatureRawlog(arguments.run);
    prepareOutputFolder(arguments.output, arguments.force);
    FrameWriters writers(arguments.output);
    FeatureSlam slam(config.slam, Camera(cameraFrom(rawlog.camera)), config.associator,
                     arguments.seed);
    PairCounts pairs;
    Trajectory path;
    for (const PixelFrame& frame : rawlog.frames)
    {
        const FrameReport report =
            toFrameReport(slam.process(frame), static_cast<long>(path.size()));
        pairs.add(report.associations, frame);
        writers.write(report);
        path.push_back(stamped(report.t_s, report.x_v.head<camera_state::kPoseSize>()));
    }
    printFigures(path, truthOf(rawlog), pairs);
}
}  // namespace monoslam
