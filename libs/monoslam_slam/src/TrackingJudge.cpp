// SPDX-License-Identifier: BSD-3-Clause
#include "TrackingJudge.h"

#include <string>

namespace monoslam
{
namespace
{
constexpr double kForget = 0.05;  ///< weight of one frame in the running share
}  // namespace

void TrackingJudge::assess(FrameReport& report, double sigma_px, bool startUnexplained,
                           bool afterGap)
{
    report.state = TrackingState::Tracking;
    poorFrames_ = report.matched < options_.min_matched ? poorFrames_ + 1 : 0;
    const AssociationCounters& counters = report.counters;
    if (counters.pairs > 0)
        rejectedShare_ += kForget * (static_cast<double>(counters.rejected) /
                                         static_cast<double>(counters.pairs) -
                                     rejectedShare_);
    const auto degraded = [&report](const std::string& why)
    {
        report.state = TrackingState::Degraded;
        report.remark = why;
    };
    if (startUnexplained) degraded("no estimate explains the pixels of the first seconds");
    if (rejectedShare_ > options_.degraded_rejected_share)
        degraded("many pairs rejected over the last frames");
    if (sigma_px > options_.degraded_residual_px)
        degraded("residuals of " + std::to_string(sigma_px) + " px");
    if (restarted_) degraded("restarted after a loss: pose and scale since then are guesses");
    if (poorFrames_ == 0) return;
    degraded(report.contradicted ? "matches contradicted by landmarks that are elsewhere"
                                 : "only " + std::to_string(report.matched) + " landmarks matched");
    const bool nothingToFind = restarted_ && report.associations.empty();
    if (poorFrames_ >= options_.lost_after || (afterGap && poorFrames_ == 1) || nothingToFind)
        report.state = TrackingState::Lost;
}

void TrackingJudge::noteRestart()
{
    restarted_ = true;
    poorFrames_ = 0;
}

void TrackingJudge::noteReturn(bool guessed)
{
    restarted_ = guessed;
    poorFrames_ = 0;
    rejectedShare_ = 0.0;
}
}  // namespace monoslam
