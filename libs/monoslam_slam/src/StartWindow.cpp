// SPDX-License-Identifier: BSD-3-Clause
#include "StartWindow.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "LandmarkFinder.h"
#include "startGuesses.h"
#include "monoslam_filter/editBelief.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kDegree = 0.017453292519943295;
constexpr double kFixed = 1e12;     ///< information of a pose that defines the world
constexpr double kUnitSigma = 1e-3; ///< relative std of a free unit, held by the window's length
constexpr int kLeastLandmarks = 8;
constexpr std::size_t kLeastViews = 4;
constexpr std::size_t kFirstLook = 8;
constexpr Eigen::Index kPoses = 18;
constexpr double kFarRho = 1e-4;

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v)
{
    Eigen::Matrix3d V;
    V << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return V;
}

double inlierRatio(const SmoothedWindow& smoothed)
{
    const auto good = std::count(smoothed.inlier.begin(), smoothed.inlier.end(), true);
    return static_cast<double>(good) / static_cast<double>(smoothed.inlier.size());
}

/** Landmark as three free numbers: from the fixed anchor, or as the known point that it is. */
WindowLandmark windowLandmark(const Belief& belief, const LandmarkSlot& slot,
                              const Eigen::Vector3d& anchor, bool known, double pointSigma)
{
    WindowLandmark landmark;
    const Eigen::Vector3d p_w = landmarkPoint(belief, slot);
    if (known)
    {
        landmark.kind = LandmarkKind::Point;
        landmark.y = p_w;
        landmark.priorMean = p_w;
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
}  // namespace

void StartWindow::record(double t_s, long frame, const Belief& belief,
                         const std::vector<Association>& associations,
                         const LandmarkRecords& records, double sigma_px)
{
    if (!open_) return;
    View view{t_s, belief.pose(), {}};
    for (const Association& seen : associations)
        if (seen.fate == Fate::Matched || seen.fate == Fate::Rejected)
            view.pixels.push_back({seen.id, seen.z, seen.R});
    for (const auto& [id, record] : records)
        if (record.bornFrame == frame)
            view.pixels.push_back(
                {id, record.born.uv_px, sigma_px * sigma_px * Eigen::Matrix2d::Identity()});
    views_.push_back(std::move(view));
}

double StartWindow::medianParallax_rad(const Belief& belief) const
{
    const Eigen::Vector3d first = views_.front().pose.head<3>();
    std::vector<double> angles;
    for (const Pixel& pixel : views_.back().pixels)
    {
        const Eigen::Index index = belief.find(pixel.id);
        if (index < 0) continue;
        const Eigen::Vector3d p_w =
            landmarkPoint(belief, belief.landmarks[static_cast<std::size_t>(index)]);
        const Eigen::Vector3d a = (p_w - first).normalized();
        const Eigen::Vector3d b = (p_w - belief.x.head<3>()).normalized();
        angles.push_back(std::atan2(a.cross(b).norm(), a.dot(b)));
    }
    if (angles.empty()) return 0.0;
    const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
    std::nth_element(angles.begin(), middle, angles.end());
    return *middle;
}

std::vector<std::size_t> StartWindow::selectViews() const
{
    const std::size_t last = views_.size() - 1;
    const auto count = static_cast<std::size_t>(options_.views);
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i + 1 < count; ++i)
        chosen.push_back(i * (last - 1) / (count - 2));
    chosen.push_back(last);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

Window StartWindow::makeWindow(const std::vector<std::size_t>& views, const Belief& belief,
                               const LandmarkRecords& records, std::vector<LandmarkId>& ids) const
{
    Window window;
    std::map<LandmarkId, int> sightings;
    for (const std::size_t view : views)
    {
        window.poses.push_back(views_[view].pose);
        for (const Pixel& pixel : views_[view].pixels) ++sightings[pixel.id];
    }
    const Eigen::Vector3d anchor = window.poses.front().head<3>();
    std::map<LandmarkId, Eigen::Index> indices;
    std::vector<double> rhos;
    for (const auto& slot : belief.landmarks)
    {
        const auto record = records.find(slot.id);
        if (record == records.end() || sightings[slot.id] < options_.min_sightings) continue;
        indices[slot.id] = static_cast<Eigen::Index>(ids.size());
        ids.push_back(slot.id);
        window.landmarks.push_back(windowLandmark(belief, slot, anchor, record->second.known,
                                                  options_.point_sigma));
        if (!record->second.known) rhos.push_back(window.landmarks.back().y(inverse_depth::kRho));
    }
    for (std::size_t v = 0; v < views.size(); ++v)
        for (const Pixel& pixel : views_[views[v]].pixels)
        {
            const auto index = indices.find(pixel.id);
            if (index == indices.end()) continue;
            window.observations.push_back(
                {static_cast<Eigen::Index>(v), index->second, pixel.z, pixel.R});
        }
    if (!rhos.empty())
    {
        // A prior as wide as the depth itself: it only keeps points without parallax finite.
        std::nth_element(rhos.begin(), rhos.begin() + static_cast<std::ptrdiff_t>(rhos.size() / 2),
                         rhos.end());
        const double median = rhos[rhos.size() / 2];
        for (auto& landmark : window.landmarks)
            if (landmark.kind == LandmarkKind::InverseDepth)
                landmark.priorInformation.z() = 1.0 / (median * median);
    }
    window.firstPoseInformation =
        (metric_ ? 1e-9 : kFixed) * Eigen::Matrix<double, 6, 6>::Identity();
    window.scaleSigma = metric_ ? 0.0 : kUnitSigma;
    return window;
}

std::vector<bool> StartWindow::trusted(const Window& window, const SmoothedWindow& smoothed) const
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
        const bool finite = landmark.kind == LandmarkKind::Point ||
                            landmark.y(inverse_depth::kRho) > 0.0;
        keep[l] = finite && good[l] >= options_.min_sightings &&
                  good[l] >= options_.min_inlier_ratio * all[l];
    }
    return keep;
}

bool StartWindow::due(const Belief& belief) const
{
    const double parallax_deg = medianParallax_rad(belief) / kDegree;
    if (parallax_deg >= options_.parallax_deg[nextThreshold_]) return true;
    // A wrong structure may hide its parallax: look again when the window has doubled.
    return parallax_deg >= 0.5 * options_.parallax_deg.front() &&
           views_.size() >= 2 * std::max<std::size_t>(lastRefined_, kFirstLook);
}

/** The best of several estimates; others than the filter's guess are tried only if that fits badly. */
SmoothedWindow StartWindow::smooth(const Window& window) const
{
    SmoothedWindow found = smoothWindow(camera_, window);
    if (found.usable && inlierRatio(found) >= options_.good_inlier_ratio) return found;
    std::vector<Window> others{flatGuess(window)};
    if (auto twoView = twoViewGuess(window, camera_)) others.push_back(std::move(*twoView));
    for (const Window& other : others)
    {
        const SmoothedWindow rival = smoothWindow(camera_, other);
        if (rival.usable && (!found.usable || rival.cost < found.cost)) found = rival;
    }
    return found;
}

std::optional<Belief> StartWindow::refine(const Belief& belief, const LandmarkRecords& records,
                                          const ConstantVelocityOptions& motion)
{
    if (!open_ || views_.size() < kLeastViews) return std::nullopt;
    if (static_cast<int>(views_.size()) > options_.max_frames)
    {
        open_ = false;
        return std::nullopt;
    }
    if (!due(belief)) return std::nullopt;
    const double parallax_deg = medianParallax_rad(belief) / kDegree;
    while (nextThreshold_ < options_.parallax_deg.size() &&
           parallax_deg >= options_.parallax_deg[nextThreshold_])
        ++nextThreshold_;
    open_ = nextThreshold_ < options_.parallax_deg.size();
    lastRefined_ = views_.size();

    std::vector<LandmarkId> ids;
    const std::vector<std::size_t> chosen = selectViews();
    const Window window = makeWindow(chosen, belief, records, ids);
    if (static_cast<int>(ids.size()) < kLeastLandmarks) return std::nullopt;
    const SmoothedWindow smoothed = smooth(window);
    lastInlierRatio_ = smoothed.usable ? inlierRatio(smoothed) : 0.0;
    if (!smoothed.usable || lastInlierRatio_ < options_.accept_inlier_ratio) return std::nullopt;
    const std::vector<bool> keep = trusted(window, smoothed);
    if (std::count(keep.begin(), keep.end(), true) < kLeastLandmarks) return std::nullopt;
    for (std::size_t v = 0; v < chosen.size(); ++v) views_[chosen[v]].pose = smoothed.poses[v];
    return rebuild(smoothed, ids, keep, motion);
}

Eigen::MatrixXd StartWindow::fromFirstView(const SmoothedWindow& smoothed) const
{
    // Errors with the first view held fixed: dp - dr0 - phi x (p - r0), phi = R0 dtheta0.
    const Eigen::Index n = smoothed.P.rows();
    Eigen::MatrixXd A = Eigen::MatrixXd::Identity(n, n);
    const Eigen::Vector3d r0 = smoothed.poses.front().head<3>();
    const Eigen::Matrix3d R0 = rotationMatrix(smoothed.poses.front().tail<4>());
    const auto turned = [&](const Eigen::Vector3d& p)
    { return Eigen::Matrix3d(crossMatrix(p - r0) * R0); };
    const std::size_t last = smoothed.poses.size() - 1;
    for (Eigen::Index i = 1; i <= 2; ++i)
    {
        const Vector7d& pose = smoothed.poses[last - 2 + static_cast<std::size_t>(i)];
        A.block<3, 3>(6 * i, 0) = -Eigen::Matrix3d::Identity();
        A.block<3, 3>(6 * i, 3) = turned(pose.head<3>());
        A.block<3, 3>(6 * i + 3, 3) = -rotationMatrix(pose.tail<4>()).transpose() * R0;
    }
    for (std::size_t l = 0; l < smoothed.landmarks.size(); ++l)
    {
        const WindowLandmark& landmark = smoothed.landmarks[l];
        const Eigen::Index at = kPoses + 3 * static_cast<Eigen::Index>(l);
        Eigen::Matrix3d J_y_p = Eigen::Matrix3d::Identity();
        Eigen::Vector3d p_w = landmark.y.head<3>();
        if (landmark.kind == LandmarkKind::InverseDepth)
        {
            Vector6d y = landmark.y;
            y(inverse_depth::kRho) = std::max(y(inverse_depth::kRho), kFarRho);
            Matrix36d J_p_y;
            p_w = toPoint(y, &J_p_y);
            J_y_p = J_p_y.rightCols<3>().inverse();
        }
        A.block<3, 3>(at, 0) = -J_y_p;
        A.block<3, 3>(at, 3) = J_y_p * turned(p_w);
    }
    A.topLeftCorner<6, 6>().setZero();
    return A * smoothed.P * A.transpose();
}

Belief StartWindow::rebuild(const SmoothedWindow& smoothed, const std::vector<LandmarkId>& ids,
                            const std::vector<bool>& keep,
                            const ConstantVelocityOptions& motion) const
{
    Eigen::MatrixXd P = metric_ ? fromFirstView(smoothed) : smoothed.P;
    // The views left out saw the landmarks too: what the filter had learnt from them is not lost.
    const double share =
        static_cast<double>(smoothed.poses.size()) / static_cast<double>(views_.size());
    const Eigen::Index landmarks = P.rows() - kPoses;
    P.bottomRows(landmarks) *= std::sqrt(share);
    P.rightCols(landmarks) *= std::sqrt(share);
    const Vector7d& before = smoothed.poses[smoothed.poses.size() - 2];
    const Vector7d& last = smoothed.poses.back();
    const double dt_s = views_.back().t_s - views_[views_.size() - 2].t_s;
    Vector13d x_v;
    x_v.head<7>() = last;
    x_v.segment<3>(camera_state::kVelocity) = (last.head<3>() - before.head<3>()) / dt_s;
    x_v.segment<3>(camera_state::kAngularVelocity) =
        quaternionLog(quaternionProduct(quaternionConjugate(before.tail<4>()), last.tail<4>())) /
        dt_s;

    Eigen::Matrix4d QL;
    (void)quaternionProduct(last.tail<4>(), Eigen::Vector4d::UnitX(), nullptr, &QL);
    const Eigen::Matrix3d R_last_before =
        rotationMatrix(last.tail<4>()).transpose() * rotationMatrix(before.tail<4>());
    Eigen::Matrix<double, 13, 18> J = Eigen::Matrix<double, 13, 18>::Zero();
    J.block<3, 3>(camera_state::kPosition, 12).setIdentity();
    J.block<4, 3>(camera_state::kOrientation, 15) = 0.5 * QL.rightCols<3>();
    J.block<3, 3>(camera_state::kVelocity, 6) = -Eigen::Matrix3d::Identity() / dt_s;
    J.block<3, 3>(camera_state::kVelocity, 12) = Eigen::Matrix3d::Identity() / dt_s;
    J.block<3, 3>(camera_state::kAngularVelocity, 9) = -R_last_before / dt_s;
    J.block<3, 3>(camera_state::kAngularVelocity, 15) = Eigen::Matrix3d::Identity() / dt_s;

    // The velocities are the mean ones of the last step: the step's own noise is added.
    const Matrix13d Q = predictConstantVelocity(x_v, dt_s, motion).Q;
    Matrix13d P_v = J * P.topLeftCorner<kPoses, kPoses>() * J.transpose();
    P_v.bottomRightCorner<6, 6>() += Q.bottomRightCorner<6, 6>();
    Belief belief = Belief::ofCamera(x_v, P_v);

    std::vector<Eigen::Index> columns;  // of the free numbers of what is already in the state
    for (std::size_t l = 0; l < keep.size(); ++l)
    {
        if (!keep[l]) continue;
        const WindowLandmark& landmark = smoothed.landmarks[l];
        const Eigen::Index at = kPoses + 3 * static_cast<Eigen::Index>(l);
        const Eigen::Index size = landmarkSize(landmark.kind);
        const Eigen::Index skip = size - 3;  // the fixed anchor of an inverse depth
        const Eigen::Index n = belief.size();
        Eigen::MatrixXd P_yx = Eigen::MatrixXd::Zero(size, n);
        Eigen::MatrixXd P_yy = Eigen::MatrixXd::Zero(size, size);
        P_yy.bottomRightCorner<3, 3>() = P.block<3, 3>(at, at);
        P_yx.block(skip, 0, 3, 13) = P.block(at, 0, 3, kPoses) * J.transpose();
        Eigen::Index offset = 13;
        for (std::size_t i = 0; i < columns.size(); ++i)
        {
            const Eigen::Index otherSize = belief.landmarks[i].size();
            P_yx.block<3, 3>(skip, offset + otherSize - 3) = P.block<3, 3>(at, columns[i]);
            offset += otherSize;
        }
        columns.push_back(at);
        belief = append(std::move(belief), ids[l], landmark.kind, landmark.y, P_yx, P_yy);
    }
    normalizeQuaternions(belief);
    return belief;
}
}  // namespace monoslam
