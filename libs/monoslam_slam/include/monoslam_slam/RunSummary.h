// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "monoslam_slam/FrameReport.h"
#include "monoslam_slam/export.h"

namespace monoslam
{
/** What a run's summary says besides its frames. */
struct RunFacts
{
    unsigned seed = 0;
    bool interrupted = false;
    std::map<std::string, std::string> input;  ///< rawlog, label, camera
    std::map<std::string, std::string> versions;
    std::map<std::string, std::map<std::string, std::string>> config;  ///< section, key, value
    std::vector<std::string> notes;                                    ///< gaps and the like
};

/** Adds up the frames of a run for summary.json and for the lines at its end. */
class MONOSLAM_SLAM_EXPORT RunSummary
{
   public:
    void add(const FrameReport& report, double decode_ms = 0.0);
    void setMap(const std::vector<MapLandmark>& map);

    [[nodiscard]] bool hasPose() const { return firstPose_ >= 0; }

    /** summary.json in the folder. */
    void write(const std::string& folder, const RunFacts& facts) const;

    /** A few lines for people. */
    [[nodiscard]] std::string text() const;

   private:
    static constexpr std::size_t kStages = 8;  ///< prepare to map, total, decode

    std::array<long, 4> states_{};  ///< frames in each TrackingState
    std::array<std::vector<double>, kStages> times_ms_;
    std::vector<double> readouts_s_;
    std::map<std::string, long> remarks_;
    std::map<std::string, long> totals_;
    std::map<std::string, long> map_;
    long firstPose_ = -1;
    double pathLength_m_ = 0.0;
    double start_s_ = 0.0;
    double end_s_ = 0.0;
    Eigen::Vector3d lastPosition_ = Eigen::Vector3d::Zero();
    std::string lastState_;
};
}  // namespace monoslam
