// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/ObservationStream.h"

#include <mrpt/obs/CSensoryFrame.h>

namespace monoslam
{
using mrpt::obs::CObservation;

ObservationStream::ObservationStream(const std::string& file) : objects_(file) {}

CObservation::Ptr ObservationStream::next()
{
    while (pending_.empty())
    {
        const auto object = objects_.next();
        if (!object) return nullptr;
        if (auto observation = std::dynamic_pointer_cast<CObservation>(object))
            pending_.push_back(std::move(observation));
        else if (auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object))
            pending_.assign(frame->begin(), frame->end());
    }
    auto observation = std::move(pending_.front());
    pending_.pop_front();
    return observation;
}
}  // namespace monoslam
