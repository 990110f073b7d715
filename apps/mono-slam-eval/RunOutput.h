// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
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
    std::map<long, double> t_s;    ///< of each frame index
};

/** A line of map.csv. */
struct MapRow
{
    long bornFrame = 0;
    Eigen::Vector2d born_px;
    std::optional<Eigen::Vector3d> p;  ///< [m]; none while its depth may be infinite
    bool known = false;                ///< a point of the metric target
};

/** A trajectory and what lies beside it in the folder of a run. */
struct RunOutput
{
    std::string name;
    Trajectory trajectory;
    std::vector<StampedCovariance> covariances;  ///< empty without covariance.csv
    FrameLog log;                                ///< empty without frames.csv
    std::string folder;                          ///< empty for a trajectory alone
};

/** \param path  a folder with trajectory.tum, or a trajectory alone
 *  \throw std::invalid_argument naming what cannot be read */
[[nodiscard]] RunOutput readRun(const std::string& path);

/** map.csv of a run's folder. \throw std::invalid_argument naming what cannot be read */
[[nodiscard]] std::vector<MapRow> readMap(const std::string& folder);
}  // namespace monoslam
