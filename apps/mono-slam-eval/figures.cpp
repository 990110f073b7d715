// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "Figure.h"

namespace monoslam
{
namespace
{
constexpr double kMm = 1000.0;
constexpr double kDeg = 180.0 / 3.14159265358979323846;
constexpr double kPercent = 100.0;

double nearestRank(std::vector<double> values, double fraction)
{
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    const double rank = std::ceil(fraction * static_cast<double>(values.size())) - 1.0;
    return values[static_cast<std::size_t>(std::max(0.0, rank))];
}

void addErrors(std::vector<Figure>& rows, const std::string& name, const TrajectoryErrors& e)
{
    const std::string key = name.empty() ? "none_" : name + "_";
    const std::string label = (name.empty() ? "unaligned" : name) + " ";
    rows.push_back({key + "ate_rmse_mm", label + "ATE rmse [mm]", kMm * e.position_m.rmse, 3});
    rows.push_back({key + "ate_mean_mm", label + "ATE mean [mm]", kMm * e.position_m.mean, 3});
    rows.push_back({key + "ate_median_mm", label + "ATE median [mm]", kMm * e.position_m.median});
    rows.push_back({key + "ate_max_mm", label + "ATE max [mm]", kMm * e.position_m.max, 3});
    rows.push_back({key + "rot_rms_deg", label + "rotation rms [deg]", kDeg * e.rotation_rad.rmse});
    rows.push_back({key + "rot_max_deg", label + "rotation max [deg]", kDeg * e.rotation_rad.max});
    rows.push_back(
        {key + "rpe_frame_rmse_mm", label + "RPE 1 frame rmse [mm]", kMm * e.stepPosition_m.rmse});
    rows.push_back(
        {key + "rpe_1s_rmse_mm", label + "RPE 1 s rmse [mm]", kMm * e.secondPosition_m.rmse});
}

void addNees(std::vector<Figure>& rows, const std::string& name, const std::vector<PosePair>& pairs,
             const RunOutput& run, const Similarity& alignment)
{
    std::vector<double> values;
    for (const auto& value : trajectoryNees(pairs, run.covariances, alignment))
        if (value) values.push_back(*value);
    const Statistics s = statistics(values);
    const std::string label = name == "none" ? "unaligned" : "first pose";
    rows.push_back({name + "_nees_mean", label + " NEES mean (6)", s.mean, 2});
    rows.push_back({name + "_nees_median", label + " NEES median (5.35)", s.median, 2});
}

void addLog(std::vector<Figure>& rows, const RunOutput& run)
{
    const FrameLog& log = run.log;
    const double none = std::numeric_limits<double>::quiet_NaN();
    const auto counted = [&](long n) { return log.frames > 0 ? static_cast<double>(n) : none; };
    rows.push_back({"frames", "frames processed", counted(log.frames), 0});
    rows.push_back({"frames_lost", "frames lost", counted(log.lost), 0});
    rows.push_back({"frames_degraded", "frames degraded", counted(log.degraded), 0});
    rows.push_back({"time_median_ms", "time median [ms]", statistics(log.total_ms).median, 2});
    rows.push_back({"time_p995_ms", "time 99.5 % [ms]", nearestRank(log.total_ms, 0.995), 2});
    rows.push_back({"time_max_ms", "time worst [ms]", nearestRank(log.total_ms, 1.0), 2});
}

Trajectory truthOf(const std::vector<PosePair>& pairs)
{
    Trajectory truth;
    for (const PosePair& pair : pairs) truth.push_back(pair.truth);
    return truth;
}
}  // namespace

std::vector<Figure> figuresAgainst(const RunOutput& run, const Trajectory& truth,
                                   const TimeMatchingOptions& options)
{
    const std::vector<PosePair> pairs = matchByTime(run.trajectory, truth, options);
    const TrajectoryErrors none = trajectoryErrors(pairs, Alignment::None);
    const TrajectoryErrors se3 = trajectoryErrors(pairs, Alignment::SE3);
    const TrajectoryErrors sim3 = trajectoryErrors(pairs, Alignment::Sim3);
    const Statistics rotation = rotationErrors(pairs);
    const ScaleDrift drift = scaleDrift(pairs);
    const double nan = std::numeric_limits<double>::quiet_NaN();

    std::vector<Figure> rows;
    rows.push_back(
        {"frames_estimated", "frames estimated", static_cast<double>(run.trajectory.size()), 0});
    rows.push_back({"frames_matched", "frames matched", static_cast<double>(pairs.size()), 0});
    rows.push_back({"truth_length_m", "path length, truth [m]", pathLength(truthOf(pairs)), 3});
    rows.push_back({"length_m", "path length, estimate", pathLength(run.trajectory), 3});
    rows.push_back(
        {"standing_still_mm", "standing still [mm]", kMm * standingStillError(pairs), 1});
    addErrors(rows, "", none);
    addErrors(rows, "SE3", se3);
    addErrors(rows, "Sim3", sim3);
    rows.push_back({"rotation_own_rms_deg", "rotation rms, own fit [deg]", kDeg * rotation.rmse});
    rows.push_back({"rpe_frame_rot_rms_deg", "RPE 1 frame rot. rms [deg]",
                    kDeg * none.stepRotation_rad.rmse, 4});
    rows.push_back(
        {"rpe_1s_rot_rms_deg", "RPE 1 s rot. rms [deg]", kDeg * none.secondRotation_rad.rmse});
    const bool fitted = pairs.size() >= 3;
    rows.push_back({"scale", "scale s, truth / estimate", fitted ? sim3.alignment.s : nan, 5});
    rows.push_back({"scale_error_pct", "scale error of estimate [%]",
                    fitted ? kPercent * (1.0 / sim3.alignment.s - 1.0) : nan, 2});
    rows.push_back(
        {"scale_drift_pct", "scale drift, 1st-3rd third [%]", kPercent * drift.drift, 2});
    rows.push_back(
        {"scale_drift_reliable", "  thirds fit well (1 = yes)", drift.reliable ? 1.0 : 0.0, 0});
    addNees(rows, "none", pairs, run, none.alignment);
    addNees(rows, "first_pose", pairs, run, alignFirstPose(pairs));
    addLog(rows, run);
    return rows;
}

std::vector<Figure> figuresOutAndBack(const RunOutput& run)
{
    const OutAndBack o = outAndBack(run.trajectory);
    std::vector<Figure> rows;
    rows.push_back(
        {"frames_estimated", "frames estimated", static_cast<double>(run.trajectory.size()), 0});
    rows.push_back({"length", "path length", o.length, 4});
    rows.push_back({"reach", "reach along the line", o.outReach, 4});
    rows.push_back({"gap_pct", "gap end-start / length [%]", kPercent * o.gap / o.length, 3});
    rows.push_back({"gap_reach_pct", "  gap / reach [%]", kPercent * o.gap / o.outReach, 3});
    rows.push_back({"off_line_pct", "off the line / length [%]", kPercent * o.offLine / o.length});
    rows.push_back(
        {"off_line_reach_pct", "  off the line / reach [%]", kPercent * o.offLine / o.outReach, 3});
    rows.push_back({"back_out_pct", "way back / way out - 1 [%]",
                    kPercent * (o.backLength / o.outLength - 1.0), 3});
    rows.push_back({"back_out_reach_pct", "  along the line only [%]",
                    kPercent * (o.backReach / o.outReach - 1.0), 3});
    addLog(rows, run);
    return rows;
}
}  // namespace monoslam
