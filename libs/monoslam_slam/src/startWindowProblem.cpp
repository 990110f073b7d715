// SPDX-License-Identifier: BSD-3-Clause
#include "startWindowProblem.h"

#include <algorithm>
#include <map>

#include "LandmarkFinder.h"
#include "monoslam_models/InverseDepth.h"

namespace monoslam
{
namespace
{
constexpr double kFixed = 1e12;      ///< information of a pose that defines the world
constexpr double kFree = 1e-9;       ///< of one that the known points hold
constexpr double kUnitSigma = 1e-3;  ///< relative std of a free unit, held by the window's length

/** Landmark as three free numbers: from the fixed anchor, or as the known point that it is. What the
 *  filter has made of a known point meanwhile is only where to begin. */
WindowLandmark windowLandmark(const Belief& belief, const LandmarkSlot& slot,
                              const Eigen::Vector3d& anchor,
                              const std::optional<Eigen::Vector3d>& known, double pointSigma)
{
    WindowLandmark landmark;
    const Eigen::Vector3d p_w = landmarkPoint(belief, slot);
    if (known)
    {
        landmark.kind = LandmarkKind::Point;
        landmark.y = p_w;
        landmark.priorMean = *known;
        landmark.priorInformation.setConstant(1.0 / (pointSigma * pointSigma));
        return landmark;
    }
    const Eigen::Vector3d g = p_w - anchor;
    Vector6d y;
    y << anchor, rayAngles(g), 1.0 / g.norm();
    landmark.y = y;
    landmark.priorMean = y.tail<3>();
    return landmark;
}
/** Landmarks of the belief that enough of the views saw. */
void addLandmarks(StartWindowProblem& problem, const std::vector<const StartView*>& views,
                  const Belief& belief, const LandmarkRecords& records, const StartOptions& options)
{
    std::map<LandmarkId, int> sightings;
    for (const StartView* view : views)
        for (const StartPixel& pixel : view->pixels) ++sightings[pixel.id];
    const Eigen::Vector3d anchor = views.front()->pose.head<3>();
    for (const auto& slot : belief.landmarks)
    {
        const auto record = records.find(slot.id);
        if (record == records.end() || sightings[slot.id] < options.min_sightings) continue;
        problem.ids.push_back(slot.id);
        problem.window.landmarks.push_back(
            windowLandmark(belief, slot, anchor, record->second.known, options.point_sigma));
    }
}

void addObservations(StartWindowProblem& problem, const std::vector<const StartView*>& views)
{
    std::map<LandmarkId, Eigen::Index> indices;
    for (std::size_t i = 0; i < problem.ids.size(); ++i)
        indices[problem.ids[i]] = static_cast<Eigen::Index>(i);
    for (std::size_t v = 0; v < views.size(); ++v)
        for (const StartPixel& pixel : views[v]->pixels)
        {
            const auto index = indices.find(pixel.id);
            if (index == indices.end()) continue;
            problem.window.observations.push_back(
                {static_cast<Eigen::Index>(v), index->second, pixel.z, pixel.R});
        }
}

/** A prior as wide as the depth itself: it only keeps points without parallax finite. */
void addDepthPrior(Window& window)
{
    std::vector<double> rhos;
    for (const auto& landmark : window.landmarks)
        if (landmark.kind == LandmarkKind::InverseDepth)
            rhos.push_back(landmark.y(inverse_depth::kRho));
    if (rhos.empty()) return;
    std::nth_element(rhos.begin(), rhos.begin() + static_cast<std::ptrdiff_t>(rhos.size() / 2),
                     rhos.end());
    const double median = rhos[rhos.size() / 2];
    for (auto& landmark : window.landmarks)
        if (landmark.kind == LandmarkKind::InverseDepth)
            landmark.priorInformation.z() = 1.0 / (median * median);
}
}  // namespace

std::vector<std::size_t> selectViews(std::size_t available, int wanted)
{
    const std::size_t last = available - 1;
    const auto count = static_cast<std::size_t>(wanted);
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i + 1 < count; ++i) chosen.push_back(i * (last - 1) / (count - 2));
    chosen.push_back(last);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

StartWindowProblem startWindowProblem(const std::vector<const StartView*>& views,
                                      const Belief& belief, const LandmarkRecords& records,
                                      const StartOptions& options, bool metric)
{
    StartWindowProblem problem;
    for (const StartView* view : views) problem.window.poses.push_back(view->pose);
    addLandmarks(problem, views, belief, records, options);
    addObservations(problem, views);
    addDepthPrior(problem.window);
    problem.window.firstPoseInformation =
        (metric ? kFree : kFixed) * Eigen::Matrix<double, 6, 6>::Identity();
    problem.window.scaleSigma = metric ? 0.0 : kUnitSigma;
    return problem;
}

std::vector<bool> trusted(const Window& window, const SmoothedWindow& smoothed,
                          const StartOptions& options)
{
    std::vector<int> good(window.landmarks.size(), 0);
    std::vector<int> all(window.landmarks.size(), 0);
    for (std::size_t i = 0; i < window.observations.size(); ++i)
    {
        const auto l = static_cast<std::size_t>(window.observations[i].landmark);
        ++all[l];
        if (smoothed.inlier[i]) ++good[l];
    }
    std::vector<bool> keep(window.landmarks.size());
    for (std::size_t l = 0; l < keep.size(); ++l)
    {
        const WindowLandmark& landmark = smoothed.landmarks[l];
        const bool finite =
            landmark.kind == LandmarkKind::Point || landmark.y(inverse_depth::kRho) > 0.0;
        keep[l] = finite && good[l] >= options.min_sightings &&
                  good[l] >= options.min_inlier_ratio * all[l];
    }
    return keep;
}
}  // namespace monoslam
