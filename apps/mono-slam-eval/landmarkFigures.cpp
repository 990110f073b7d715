// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <limits>

#include "Figure.h"

namespace monoslam
{
namespace
{
constexpr double kPercent = 100.0;

struct Matched
{
    Eigen::Vector3d estimate;
    Eigen::Vector3d truth;
    double distance_m = 0.0;  ///< of the true point from the true camera of its first frame
};

struct MatchedMap
{
    std::vector<Matched> landmarks;
    long withoutPoint = 0;
    long withoutTruth = 0;
};

MatchedMap matchMap(const RunOutput& run, LandmarkTruth& truth)
{
    MatchedMap matched;
    for (const MapRow& row : readMap(run.folder))
    {
        if (row.known) continue;  // of the target: not estimated
        const auto t_s = run.log.t_s.find(row.bornFrame);
        const auto p =
            t_s == run.log.t_s.end() ? std::nullopt : truth.point(t_s->second, row.born_px);
        if (!p)
            ++matched.withoutTruth;
        else if (!row.p)
            ++matched.withoutPoint;
        else
            matched.landmarks.push_back({*row.p, p->p_w, p->distance_m});
    }
    return matched;
}

void addAligned(std::vector<Figure>& rows, const std::string& name, const MatchedMap& map,
                const Similarity& alignment)
{
    std::vector<double> errors_m, relative;
    for (const Matched& m : map.landmarks)
    {
        const Eigen::Vector3d p = alignment.s * alignment.R * m.estimate + alignment.t;
        errors_m.push_back((p - m.truth).norm());
        relative.push_back(kPercent * errors_m.back() / m.distance_m);
    }
    const Statistics s = statistics(errors_m);
    const std::string key = (name.empty() ? "none" : name) + "_landmark_";
    const std::string label = (name.empty() ? "unaligned" : name) + " landmarks ";
    rows.push_back({key + "mean_m", label + "mean [m]", s.mean, 4});
    rows.push_back({key + "median_m", label + "median [m]", s.median, 4});
    rows.push_back({key + "rmse_m", label + "rmse [m]", s.rmse, 4});
    rows.push_back(
        {key + "relative_median_pct", label + "median [%]", statistics(relative).median, 2});
}
}  // namespace

std::vector<Figure> landmarkFigures(const RunOutput& run, const std::vector<PosePair>& pairs,
                                    LandmarkTruth& truth)
{
    const MatchedMap map = matchMap(run, truth);
    std::vector<Figure> rows;
    rows.push_back(
        {"landmark_count", "landmarks compared", static_cast<double>(map.landmarks.size()), 0});
    rows.push_back({"landmark_without_point", "  without a finite depth",
                    static_cast<double>(map.withoutPoint), 0});
    rows.push_back({"landmark_without_truth", "  without a true point",
                    static_cast<double>(map.withoutTruth), 0});
    addAligned(rows, "", map, {});
    addAligned(rows, "SE3", map, align(pairs, Alignment::SE3));
    addAligned(rows, "Sim3", map, align(pairs, Alignment::Sim3));
    return rows;
}
}  // namespace monoslam
