// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/MonoSlam.h"

#include <utility>

#include "MonoSlamImpl.h"
#include "listLandmarks.h"

namespace monoslam
{
MonoSlam::MonoSlam(MonoSlamOptions options, const Camera& camera,
                   std::unique_ptr<Associator> associator, unsigned seed, FilterEngine engine)
    : impl_(std::make_unique<Impl>(std::move(options), camera, std::move(associator),
                                   std::move(engine), seed))
{
}
MonoSlam::~MonoSlam() = default;
MonoSlam::MonoSlam(MonoSlam&&) noexcept = default;
MonoSlam& MonoSlam::operator=(MonoSlam&&) noexcept = default;

FrameReport MonoSlam::process(const Frame& frame)
{
    impl_->check(frame);
    ThreadClock clock;
    ThreadClock whole;
    FrameReport report;
    report.t_s = frame.t_s;
    report.index = frame.index;
    const FrameContext context{prepareImage(frame.image, impl_->options.search.smoothing_px),
                               frame.index};
    report.times.prepare_ms = clock.lap_ms();
    const double dt_s = frame.t_s - std::exchange(impl_->t_s, frame.t_s);
    impl_->anyFrame = true;
    if (impl_->mixture.empty())
    {
        report.remark = impl_->start(context, frame.image);
        if (!impl_->mixture.empty()) report.state = TrackingState::Tracking;
    }
    else
    {
        const bool returned = impl_->returnToLostMap(context);
        report.times.prepare_ms += clock.lap_ms();
        impl_->trackAndJudge(context, returned ? 0.0 : dt_s, returned, report, clock);
        if (report.state == TrackingState::Lost) impl_->lose(context, report, clock);
    }
    impl_->refineStart(context, report);
    report.times.map_ms = clock.lap_ms();
    report.times.total_ms = whole.lap_ms() + report.counters.otherThreadsMs;
    impl_->summarize(report);
    return report;
}

void MonoSlam::observeProblems(ProblemObserver observer)
{
    impl_->observer = std::move(observer);
}

const Mixture& MonoSlam::mixture() const
{
    return impl_->mixture;
}
const Camera& MonoSlam::camera() const
{
    return impl_->camera;
}

std::vector<MapLandmark> MonoSlam::map() const
{
    if (impl_->mixture.empty()) return {};
    return listLandmarks(best(impl_->mixture), impl_->keeper.records());
}
}  // namespace monoslam
