// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "monoslam_eval/Trajectory.h"
#include "monoslam_eval/consistency.h"

namespace monoslam
{
/** What frames.csv says about a run. */
struct FrameLog
{
    long frames = 0;
    long lost = 0;
    long degraded = 0;
    std::vector<double> total_ms;  ///< thread CPU time of each frame
};

/** A trajectory and what lies beside it in the folder of a run. */
struct RunOutput
{
    std::string name;
    Trajectory trajectory;
    std::vector<StampedCovariance> covariances;  ///< empty without covariance.csv
    FrameLog log;                                ///< empty without frames.csv
};

/** \param path  a folder with trajectory.tum, or a trajectory alone
 *  \throw std::invalid_argument naming what cannot be read */
[[nodiscard]] RunOutput readRun(const std::string& path);
}  // namespace monoslam
