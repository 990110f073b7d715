// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <optional>

#include "monoslam_mrpt/RawlogObjectStream.h"

namespace monoslam
{
/** One step of a rawlog: what the robot did and then saw. */
struct Step
{
    mrpt::obs::CActionCollection::Ptr action;
    mrpt::obs::CSensoryFrame::Ptr observations;
    long entries = 0;       ///< of the rawlog, up to here
    std::size_t frame = 0;  ///< index of the observations among all of the rawlog
};

/** Pairs of actions and observations, which is the format that kf-slam reads. */
class StepPairs
{
   public:
    explicit StepPairs(const std::string& rawlog) : file_(rawlog), objects_(rawlog) {}

    /** The next pair, or nothing at the end; what does not pair is skipped.
     *  \throw std::runtime_error naming the file, if it is damaged or no pair was in it */
    std::optional<Step> next();

   private:
    std::string file_;
    RawlogObjectStream objects_;
    long entries_ = 0;
    std::size_t frames_ = 0;
    long pairs_ = 0;
};
}  // namespace monoslam
