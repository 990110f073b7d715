// SPDX-License-Identifier: BSD-3-Clause
#include "StartWindow.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "LandmarkFinder.h"
#include "beliefFromWindow.h"
#include "monoslam_models/rowPose.h"
#include "startGuesses.h"

namespace monoslam
{
namespace
{
constexpr double kClearlyBetter = 0.9;  ///< cost of another solution over that of the filter's own
constexpr double kHopeless = 2.0;       ///< the same before its outliers are known
constexpr double kWorse = 2.0;          ///< cost of a pixel over the least of earlier estimates
constexpr double kDegree = 0.017453292519943295;
constexpr int kLeastLandmarks = 8;
constexpr long kLeastSeenLast = 15;  ///< landmarks that hold the last view in the new map
constexpr std::size_t kLeastViews = 4;
constexpr std::size_t kFirstLook = 8;
constexpr std::size_t kAmbiguousThresholds = 2;  ///< of the parallax, the first ones

double inlierRatio(const SmoothedWindow& smoothed)
{
    const auto good = std::count(smoothed.inlier.begin(), smoothed.inlier.end(), true);
    return static_cast<double>(good) / static_cast<double>(smoothed.inlier.size());
}

double costOfPixel(const SmoothedWindow& smoothed)
{
    return smoothed.cost / static_cast<double>(smoothed.inlier.size());
}

/** Median angle between what is seen of the points from two places; 0 without points. */
double medianParallax_rad(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& from,
                          const Eigen::Vector3d& to)
{
    std::vector<double> angles;
    for (const Eigen::Vector3d& p_w : points)
    {
        const Eigen::Vector3d a = (p_w - from).normalized();
        const Eigen::Vector3d b = (p_w - to).normalized();
        angles.push_back(std::atan2(a.cross(b).norm(), a.dot(b)));
    }
    if (angles.empty()) return 0.0;
    const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
    std::nth_element(angles.begin(), middle, angles.end());
    return *middle;
}

/** Between the first and the last view, by the pixels of the last that the estimate explains [rad]. */
double parallaxOf_rad(const Window& window, const SmoothedWindow& smoothed)
{
    const auto last = static_cast<Eigen::Index>(window.poses.size()) - 1;
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < window.observations.size(); ++i)
    {
        const WindowObservation& seen = window.observations[i];
        if (seen.view != last || !smoothed.inlier[i]) continue;
        const WindowLandmark& landmark =
            smoothed.landmarks[static_cast<std::size_t>(seen.landmark)];
        points.push_back(landmarkPoint(landmark.kind, landmark.y));
    }
    return medianParallax_rad(points, smoothed.poses.front().head<3>(),
                              smoothed.poses.back().head<3>());
}

/** Pixels of the last view that its landmarks kept explain. */
long seenLast(const Window& window, const WindowEstimate& estimate)
{
    const auto last = static_cast<Eigen::Index>(window.poses.size()) - 1;
    long count = 0;
    for (std::size_t i = 0; i < window.observations.size(); ++i)
    {
        const WindowObservation& seen = window.observations[i];
        if (seen.view == last && estimate.smoothed.inlier[i] &&
            estimate.keep[static_cast<std::size_t>(seen.landmark)])
            ++count;
    }
    return count;
}
}  // namespace

void StartWindow::record(double t_s, long frame, const Belief& belief,
                         const std::vector<Association>& associations,
                         const LandmarkRecords& records, double sigma_px)
{
    if (!open_) return;
    StartView view{t_s, belief.pose(), {}};
    const auto keep = [&](LandmarkId id, const Eigen::Vector2d& z, const Eigen::Matrix2d& R)
    {
        const Eigen::Index index = belief.find(id);
        if (index < 0) return;
        const Eigen::Vector3d p_w =
            landmarkPoint(belief, belief.landmarks[static_cast<std::size_t>(index)]);
        const double rho = 1.0 / (p_w - belief.x.head<3>()).norm();
        if (const auto uv = globalPixel(camera_, belief.camera(), z, rho))
            view.pixels.push_back({id, *uv, R});
    };
    for (const Association& seen : associations)
        if (seen.fate == Fate::Matched || seen.fate == Fate::Rejected)
            keep(seen.id, seen.z, seen.R);
    for (const auto& [id, record] : records)
        if (record.bornFrame == frame)
            keep(id, record.born.uv_px, sigma_px * sigma_px * Eigen::Matrix2d::Identity());
    views_.push_back(std::move(view));
}

double StartWindow::seenParallax_deg(const Belief& belief) const
{
    std::vector<Eigen::Vector3d> points;
    for (const StartPixel& pixel : views_.back().pixels)
    {
        const Eigen::Index index = belief.find(pixel.id);
        if (index < 0) continue;
        points.push_back(landmarkPoint(belief, belief.landmarks[static_cast<std::size_t>(index)]));
    }
    return medianParallax_rad(points, views_.front().pose.head<3>(), belief.x.head<3>()) / kDegree;
}

bool StartWindow::enough(double parallax_deg) const
{
    return parallax_deg >= 0.5 * options_.parallax_deg.front();
}

StartWindow::Look StartWindow::due(double parallax_deg) const
{
    if (parallax_deg >= options_.parallax_deg[nextThreshold_]) return Look::ForEstimate;
    // A wrong structure may hide its parallax: look again when the window has doubled.
    if (views_.size() < 2 * std::max<std::size_t>(lastLook_, kFirstLook)) return Look::Not;
    return enough(parallax_deg) ? Look::ForEstimate : Look::ForOther;
}

void StartWindow::passThresholds(double parallax_deg)
{
    while (nextThreshold_ < options_.parallax_deg.size() &&
           parallax_deg >= options_.parallax_deg[nextThreshold_])
        ++nextThreshold_;
    open_ = nextThreshold_ < options_.parallax_deg.size();
    lastLook_ = views_.size();
}

/** The best of several estimates. Others than the filter's guess are tried as long as the parallax is
 *  small, where a wrong structure can explain nearly all pixels, and later if that guess fits badly or
 *  much worse than earlier ones: the pixels' noise does not grow, but what is wrong with a structure
 *  shows when the parallax does. */
SmoothedWindow StartWindow::smooth(const Window& window, bool& ownGuess) const
{
    SmoothedWindow found = smoothWindow(camera_, window);
    const bool fits = found.usable && inlierRatio(found) >= options_.good_inlier_ratio &&
                      costOfPixel(found) <= kWorse * leastCost_;
    if (fits && nextThreshold_ > kAmbiguousThresholds) return found;
    std::vector<Window> others{flatGuess(window)};
    if (auto twoView = twoViewGuess(window, camera_)) others.push_back(std::move(*twoView));
    WindowOptions trial;
    trial.covariance = false;
    for (Window& other : others)
    {
        if (found.usable) trial.hopelessCost = kHopeless * found.cost;
        SmoothedWindow rival = smoothWindow(camera_, other, trial);
        if (rival.usable && (!found.usable || rival.cost < kClearlyBetter * found.cost))
        {
            other.poses = std::move(rival.poses);
            other.landmarks = std::move(rival.landmarks);
            found = smoothWindow(camera_, other);
            ownGuess = false;
        }
    }
    return found;
}

std::optional<RefinedStart> StartWindow::refine(const Belief& belief,
                                                const LandmarkRecords& records,
                                                const ConstantVelocityOptions& motion)
{
    if (!open_ || views_.size() < kLeastViews) return std::nullopt;
    if (static_cast<int>(views_.size()) > options_.max_frames)
    {
        open_ = false;
        return std::nullopt;
    }
    const double parallax_deg = seenParallax_deg(belief);
    const Look look = due(parallax_deg);
    if (look == Look::Not) return std::nullopt;
    passThresholds(parallax_deg);

    const std::vector<std::size_t> chosen = selectViews(views_.size(), options_.views);
    std::vector<const StartView*> views;
    for (const std::size_t view : chosen) views.push_back(&views_[view]);
    StartWindowProblem problem = startWindowProblem(views, belief, records, options_, metric_);
    if (static_cast<int>(problem.ids.size()) < kLeastLandmarks) return std::nullopt;
    WindowEstimate estimate;
    bool ownGuess = true;
    estimate.smoothed = smooth(problem.window, ownGuess);
    const SmoothedWindow& smoothed = estimate.smoothed;
    const bool other = !ownGuess || (smoothed.usable &&
                                     enough(parallaxOf_rad(problem.window, smoothed) / kDegree));
    if (look == Look::ForOther && !other) return std::nullopt;
    lastInlierRatio_ = smoothed.usable ? inlierRatio(smoothed) : 0.0;
    if (smoothed.usable) leastCost_ = std::min(leastCost_, costOfPixel(smoothed));
    if (!smoothed.usable || lastInlierRatio_ < options_.accept_inlier_ratio) return std::nullopt;
    estimate.keep = trusted(problem.window, smoothed, options_);
    if (std::count(estimate.keep.begin(), estimate.keep.end(), true) < kLeastLandmarks)
        return std::nullopt;
    if (seenLast(problem.window, estimate) < kLeastSeenLast)
    {
        open_ = false;  // the camera has turned away: what the window knows is behind it
        return std::nullopt;
    }
    RefinedStart refined;
    for (std::size_t l = 0; l < estimate.keep.size(); ++l)
        if (!estimate.keep[l]) refined.distrusted.push_back(problem.ids[l]);
    for (std::size_t v = 0; v < chosen.size(); ++v) views_[chosen[v]].pose = smoothed.poses[v];
    estimate.ids = std::move(problem.ids);
    estimate.share =
        static_cast<double>(smoothed.poses.size()) / static_cast<double>(views_.size());
    estimate.dt_s = views_.back().t_s - views_[views_.size() - 2].t_s;
    estimate.metric = metric_;
    refined.belief = beliefFromWindow(estimate, motion);
    return refined;
}
}  // namespace monoslam
