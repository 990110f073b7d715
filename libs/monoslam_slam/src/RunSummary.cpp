// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/RunSummary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numeric>

#include "monoslam_slam/writers.h"

namespace monoslam
{
namespace
{
constexpr std::array<const char*, 8> kStageNames{"prepare", "predict", "search", "associate",
                                                 "update",  "map",     "total",  "decode"};
constexpr std::size_t kTotal = 6;

double quantile(std::vector<double> values, double q)
{
    if (values.empty()) return 0.0;
    const double last = static_cast<double>(values.size() - 1);
    const auto k = static_cast<long>(std::ceil(q * last));
    std::nth_element(values.begin(), values.begin() + k, values.end());
    return values[static_cast<std::size_t>(k)];
}

double sum(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/** Median over the second half of a run, when an estimate has settled. */
double settledReadout_s(const std::vector<double>& readouts_s)
{
    const auto half = static_cast<std::ptrdiff_t>(readouts_s.size() / 2);
    return quantile({readouts_s.begin() + half, readouts_s.end()}, 0.5);
}

nlohmann::json figuresOf(const std::vector<double>& times_ms, double total_ms)
{
    return {{"median_ms", quantile(times_ms, 0.5)},
            {"p99_5_ms", quantile(times_ms, 0.995)},
            {"max_ms", quantile(times_ms, 1.0)},
            {"share", total_ms > 0 ? sum(times_ms) / total_ms : 0.0}};
}
}  // namespace

void RunSummary::add(const FrameReport& report, double decode_ms)
{
    const StageTimes& t = report.times;
    const double ms[kStages] = {t.prepare_ms, t.predict_ms, t.search_ms, t.associate_ms,
                                t.update_ms,  t.map_ms,     t.total_ms,  decode_ms};
    for (std::size_t i = 0; i < kStages; ++i) times_ms_[i].push_back(ms[i]);
    ++states_.at(static_cast<std::size_t>(report.state));
    lastState_ = name(report.state);
    if (!report.remark.empty()) ++remarks_[lastState_ + ": " + report.remark];
    totals_["pairs"] += report.counters.pairs;
    totals_["rejected"] += report.counters.rejected;
    totals_["matched"] += report.matched;
    totals_["added"] += report.added;
    totals_["removed"] += report.removed;
    totals_["faults"] += report.counters.faults;
    totals_["capped"] += report.counters.capped;
    totals_["frames_not_proved"] += report.counters.provedOptimal ? 0 : 1;
    if (times_ms_[0].size() == 1) start_s_ = report.t_s;
    end_s_ = report.t_s;
    if (!report.hasPose()) return;
    readouts_s_.push_back(report.readout_s);
    const Eigen::Vector3d r_wc = report.x_v.head<3>();
    if (firstPose_ >= 0) pathLength_m_ += (r_wc - lastPosition_).norm();
    if (firstPose_ < 0) firstPose_ = report.index;
    lastPosition_ = r_wc;
}

void RunSummary::setMap(const std::vector<MapLandmark>& map)
{
    map_ = {{"landmarks", 0}, {"inverse_depth", 0}, {"points", 0}, {"known", 0}};
    for (const auto& landmark : map)
    {
        ++map_["landmarks"];
        ++map_[landmark.kind == LandmarkKind::InverseDepth ? "inverse_depth" : "points"];
        map_["known"] += landmark.known ? 1 : 0;
    }
}

void RunSummary::write(const std::string& folder, const RunFacts& facts) const
{
    nlohmann::ordered_json json;
    json["interrupted"] = facts.interrupted;
    json["frames"] = times_ms_[kTotal].size();
    for (std::size_t i = 0; i < states_.size(); ++i)
        json["frames_" + name(static_cast<TrackingState>(i))] = states_[i];
    json["final_state"] = lastState_;
    json["first_pose_frame"] = firstPose_;
    json["duration_s"] = end_s_ - start_s_;
    json["path_length"] = pathLength_m_;
    json["readout_s"] = settledReadout_s(readouts_s_);
    json["remarks"] = remarks_;
    json["totals"] = totals_;
    json["map"] = map_;
    const double total_ms = sum(times_ms_[kTotal]);
    for (std::size_t i = 0; i < kStages; ++i)
        json["times"][kStageNames[i]] = figuresOf(times_ms_[i], total_ms);
    json["seed"] = facts.seed;
    json["input"] = facts.input;
    json["notes"] = facts.notes;
    json["versions"] = facts.versions;
    json["config"] = facts.config;
    const auto replace = nlohmann::json::error_handler_t::replace;
    OutputFile(folder + "/summary.json").write(json.dump(2, ' ', false, replace) + "\n");
}

std::string RunSummary::text() const
{
    const auto& total = times_ms_[kTotal];
    char line[400];
    std::snprintf(
        line, sizeof line,
        "%zu frames: %ld tracking, %ld degraded, %ld lost, %ld waiting; state at the end: "
        "%s\npath %.4f long, time a frame: median %.2f ms, 99.5 %% %.2f ms, worst %.2f ms\n",
        total.size(), states_[1], states_[2], states_[3], states_[0], lastState_.c_str(),
        pathLength_m_, quantile(total, 0.5), quantile(total, 0.995), quantile(total, 1.0));
    std::string text = line;
    for (const auto& [remark, count] : remarks_)
        text += "  " + std::to_string(count) + " frames " + remark + "\n";
    return text;
}
}  // namespace monoslam
