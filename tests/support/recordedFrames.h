// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PerspectiveFrame.h"
#include "monoslam_association/RecordedFrame.h"

namespace monoslam::test
{
inline RecordedFrame record(const PerspectiveFrame& seen)
{
    RecordedFrame frame;
    frame.index = 17;
    frame.mixture = {{seen.belief, 0.0}};
    frame.camera = seen.camera;
    frame.visibility = seen.visibility;
    frame.minScore = 0.7;
    return recordFrame(std::move(frame), seen.view());
}

inline RecordedFrame exampleFrame()
{
    RecordedFrame frame = record(PerspectiveFrame({6, 5, true, 0.5, 0.2, 2, true}, 3));
    frame.landmarks[0].truth = 0;
    frame.landmarks[1].truth = -1;
    return frame;
}
}  // namespace monoslam::test
