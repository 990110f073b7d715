// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/Trajectory.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kSameTime_s = 1e-6;

std::optional<StampedPose> parsePose(const std::string& line)
{
    std::istringstream in(line);
    StampedPose pose;
    Eigen::Vector3d& r = pose.r_wc;
    Eigen::Vector4d& q = pose.q_wc;
    std::string rest;
    if (!(in >> pose.t_s >> r[0] >> r[1] >> r[2] >> q[1] >> q[2] >> q[3] >> q[0])) return {};
    if (in >> rest) return {};
    const bool finite = std::isfinite(pose.t_s) && r.allFinite() && q.allFinite();
    if (!finite || std::abs(q.norm() - 1.0) > 0.01) return {};
    q.normalize();
    return pose;
}

StampedPose interpolate(const StampedPose& before, const StampedPose& after, double t_s)
{
    const double f = (t_s - before.t_s) / (after.t_s - before.t_s);
    Eigen::Vector4d q_step = quaternionProduct(quaternionConjugate(before.q_wc), after.q_wc);
    if (q_step[0] < 0.0) q_step = -q_step;
    StampedPose pose;
    pose.t_s = t_s;
    pose.r_wc = (1.0 - f) * before.r_wc + f * after.r_wc;
    pose.q_wc = quaternionProduct(before.q_wc, quaternionExp(f * quaternionLog(q_step)));
    return pose;
}

std::optional<StampedPose> poseAt(const Trajectory& truth, double t_s,
                                  const TimeMatchingOptions& options)
{
    const auto after = std::lower_bound(truth.begin(), truth.end(), t_s,
                                        [](const StampedPose& p, double t) { return p.t_s < t; });
    const bool bracketed = after != truth.begin() && after != truth.end();
    auto nearest = after;
    if (after == truth.end() || (bracketed && t_s - (after - 1)->t_s <= after->t_s - t_s))
        nearest = after - 1;
    const double distance_s = std::abs(nearest->t_s - t_s);
    if (distance_s > options.tolerance_s) return {};
    if (options.interpolate && bracketed && distance_s > kSameTime_s &&
        after->t_s - (after - 1)->t_s <= 2.0 * options.tolerance_s)
        return interpolate(*(after - 1), *after, t_s);
    StampedPose pose = *nearest;
    pose.t_s = t_s;
    return pose;
}
}  // namespace

Trajectory readTum(const std::string& fileName)
{
    std::ifstream file(fileName);
    if (!file) throw std::invalid_argument(fileName + ": cannot be read");
    Trajectory trajectory;
    std::string line;
    for (long number = 1; std::getline(file, line); ++number)
    {
        const auto first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#') continue;
        const std::string where = fileName + ":" + std::to_string(number) + ": ";
        const std::optional<StampedPose> pose = parsePose(line);
        if (!pose) throw std::invalid_argument(where + "not 't x y z qx qy qz qw' with |q| = 1");
        if (!trajectory.empty() && pose->t_s <= trajectory.back().t_s)
            throw std::invalid_argument(where + "time does not increase");
        trajectory.push_back(*pose);
    }
    return trajectory;
}

std::vector<PosePair> matchByTime(const Trajectory& estimate, const Trajectory& truth,
                                  const TimeMatchingOptions& options)
{
    std::vector<PosePair> pairs;
    if (truth.empty()) return pairs;
    for (std::size_t i = 0; i < estimate.size(); ++i)
        if (const auto pose = poseAt(truth, estimate[i].t_s, options))
            pairs.push_back({i, estimate[i], *pose});
    return pairs;
}

double pathLength(const Trajectory& trajectory)
{
    double length = 0.0;
    for (std::size_t i = 1; i < trajectory.size(); ++i)
        length += (trajectory[i].r_wc - trajectory[i - 1].r_wc).norm();
    return length;
}
}  // namespace monoslam
