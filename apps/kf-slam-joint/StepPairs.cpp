// SPDX-License-Identifier: BSD-3-Clause
#include "StepPairs.h"

#include <stdexcept>

namespace monoslam
{
using mrpt::obs::CActionCollection;
using mrpt::obs::CSensoryFrame;

std::optional<Step> StepPairs::next()
{
    Step step;
    while (const auto object = objects_.next())
    {
        ++entries_;
        if (auto action = std::dynamic_pointer_cast<CActionCollection>(object))
            step.action = std::move(action);
        else if (auto observations = std::dynamic_pointer_cast<CSensoryFrame>(object))
        {
            step.frame = frames_++;
            if (!step.action) continue;
            step.observations = std::move(observations);
            step.entries = entries_;
            ++pairs_;
            return step;
        }
    }
    if (pairs_ == 0)
        throw std::runtime_error(file_ + ": holds no pairs of actions and observations");
    return std::nullopt;
}
}  // namespace monoslam
