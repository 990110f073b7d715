// SPDX-License-Identifier: BSD-3-Clause
// How landmarks enter the map: known points, undelayed, and delayed by parallax.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "LandmarkFinder.h"
#include "MapKeeper.h"
#include "monoslam_models/quaternion.h"
#include "monoslam_slam/FrameReport.h"

namespace monoslam
{
namespace
{
constexpr double kDegree = 0.017453292519943295;
constexpr double kEpipolarSigmas = 3.0 * 1.5;
constexpr double kWorthDetecting = 0.1;  // of the target: fewer missing landmarks can wait
}  // namespace

Mixture MapKeeper::addKnownPoints(Mixture mixture, const MetricPose& target,
                                  const FrameContext& frame)
{
    // The camera's first pose is exact by definition of the world; what PnP does not know of it is
    // the common error of the points:  dp = -dr0 - phi x (p - r0),  phi = R0 dtheta0.
    const double sigma = options_.metricStart.point_sigma_m;
    const Vector7d& pose = target.pose;
    const Eigen::Matrix3d R_wc = rotationMatrix(pose.tail<4>());
    Eigen::Matrix<double, Eigen::Dynamic, 6> J(3 * static_cast<Eigen::Index>(target.points_m.size()), 6);
    for (std::size_t i = 0; i < target.points_m.size(); ++i)
    {
        const Eigen::Vector3d d = target.points_m[i] - pose.head<3>();
        const auto row = 3 * static_cast<Eigen::Index>(i);
        J.block<3, 3>(row, 0) = -Eigen::Matrix3d::Identity();
        for (Eigen::Index k = 0; k < 3; ++k) J.block<3, 1>(row, 3 + k) = d.cross(R_wc.col(k));
    }
    Vector13d x_v = Vector13d::Zero();
    Matrix13d P_v = Matrix13d::Zero();
    x_v.head<7>() = pose;
    P_v.topLeftCorner<7, 7>() = target.P;
    Eigen::MatrixXd P_pp = J * poseCovariance(x_v, P_v) * J.transpose();
    P_pp.diagonal().array() += sigma * sigma;
    for (std::size_t i = 0; i < target.points_m.size(); ++i)
    {
        const LandmarkId id = nextId_++;
        const auto row = 3 * static_cast<Eigen::Index>(i);
        for (auto& weighted : mixture)
        {
            Eigen::MatrixXd P_yx = Eigen::MatrixXd::Zero(3, weighted.belief.size());
            P_yx.rightCols(row) = P_pp.block(row, 0, 3, row);
            weighted.belief =
                append(std::move(weighted.belief), id, LandmarkKind::Point, target.points_m[i],
                       P_yx, P_pp.block<3, 3>(row, row));
        }
        LandmarkRecord record;
        record.born = {frame.image, target.pixels_px[i], best(mixture).pose()};
        record.bornFrame = record.lastSeen = frame.index;
        record.known = true;
        records_[id] = record;
    }
    return mixture;
}

Mixture MapKeeper::addUndelayedAt(Mixture mixture, const Eigen::Vector2d& uv,
                                  const UndelayedPrior& prior, const FrameContext& frame)
{
    const LandmarkId id = nextId_++;
    for (auto& weighted : mixture)
    {
        auto grown = addUndelayed(weighted.belief, camera_, id, uv, prior);
        if (!grown) return mixture;  // depends on pixel and lens only: the same for every belief
        weighted.belief = std::move(*grown);
    }
    LandmarkRecord record;
    record.born = {frame.image, uv, best(mixture).pose()};
    record.bornFrame = record.lastSeen = frame.index;
    records_[id] = record;
    ++added_;
    return mixture;
}

Mixture MapKeeper::addFirst(Mixture mixture, const FrameContext& frame, double rho0,
                            double sigma_rho)
{
    UndelayedPrior prior = priorNow(best(mixture));
    prior.rho0 = rho0;
    prior.sigma_rho = sigma_rho;
    const auto corners =
        detectCorners(*frame.image, takenPixels(best(mixture)), options_.map.measured_target,
                      options_.detection, strongest_, rng_);
    for (const Corner& corner : corners)
        mixture = addUndelayedAt(std::move(mixture), corner.uv_px, prior, frame);
    return mixture;
}

bool MapKeeper::mayEnter(const TrackedCorner& corner) const
{
    const InitializationOptions& rule = options_.initialization;
    if (!corner.triangulation || corner.seen < rule.min_seen) return false;
    const Triangulation& t = *corner.triangulation;
    const double rho = t.y(inverse_depth::kRho);
    const double least = rule.angle_min_deg * kDegree;
    const auto oblique = [least](double angle) { return angle > least && angle < M_PI - least; };
    return rho > 0.0 && t.alpha_rad >= rule.alpha_min_deg * kDegree && t.baseline >= rule.b_min &&
           t.baseline * rho >= rule.b_min_relative && oblique(t.beta_rad) &&
           oblique(t.gamma_rad) &&
           t.epipolarResidual_rad < kEpipolarSigmas / camera_.parameters().fx_px;
}

Mixture MapKeeper::promoteCandidates(Mixture mixture, const FrameContext& frame)
{
    const UndelayedPrior noise = priorNow(best(mixture));
    std::vector<TrackedCorner> waiting;
    for (TrackedCorner& known : corners_)
    {
        auto corner = trackCorner(std::move(known), best(mixture), camera_, *frame.image,
                                  frame.index, trackerOptions(options_.search));
        if (!corner) continue;
        if (!mayEnter(*corner))
        {
            waiting.push_back(std::move(*corner));
            continue;
        }
        Mixture grown = mixture;
        for (auto& weighted : grown)
            weighted.belief = addTriangulated(std::move(weighted.belief), corner->id,
                                              *corner->triangulation, corner->first,
                                              noise.sigma_px, options_.initialization.sigma_floor);
        const Belief& after = best(grown);
        const Eigen::Index rho = after.landmarks.back().offset + inverse_depth::kRho;
        if (std::sqrt(after.P(rho, rho)) > options_.initialization.max_relative_sigma * after.x(rho))
        {
            waiting.push_back(std::move(*corner));
            continue;
        }
        mixture = std::move(grown);
        LandmarkRecord record;
        record.born = corner->born;
        record.born.pose = corner->first.pose;
        record.bornFrame = corner->bornFrame;
        record.lastSeen = frame.index;
        records_[corner->id] = record;
        ++added_;
    }
    corners_ = std::move(waiting);
    return mixture;
}

Mixture MapKeeper::startCandidates(Mixture mixture, const std::vector<Eigen::Vector2d>& pixels,
                                   const FrameContext& frame)
{
    if (pixels.empty()) return mixture;
    const InitializationOptions& rule = options_.initialization;
    const CloneId clone = rule.clone ? nextClone_++ : -1;
    const UndelayedPrior prior = priorNow(best(mixture));
    if (rule.clone)
    {
        const auto& clones = best(mixture).clones;
        if (static_cast<int>(clones.size()) >= rule.max_clones)
        {
            const CloneId oldest = clones.front().id;
            corners_.erase(std::remove_if(corners_.begin(), corners_.end(),
                                          [oldest](const TrackedCorner& corner)
                                          { return corner.first.clone == oldest; }),
                           corners_.end());
            mixture = dropUnusedClones(std::move(mixture));
        }
        for (auto& weighted : mixture)
            weighted.belief = addClone(std::move(weighted.belief), clone);
    }
    for (const auto& uv : pixels)
    {
        TrackedCorner corner;
        corner.id = nextId_++;
        corner.born = {frame.image, uv, best(mixture).pose()};
        corner.first.clone = clone;
        corner.first.pose = best(mixture).pose();
        corner.first.variance = best(mixture).P.diagonal().head<7>();
        corner.first.uv_px = uv;
        corner.uv_px = uv;
        corner.rho = prior.rho0;
        corner.sigma_rho = prior.sigma_rho;
        corner.bornFrame = frame.index;
        corners_.push_back(corner);
    }
    return mixture;
}

Mixture MapKeeper::dropUnusedClones(Mixture mixture) const
{
    for (auto& weighted : mixture)
    {
        std::vector<CloneId> unused;
        for (const auto& slot : weighted.belief.clones)
            if (std::none_of(corners_.begin(), corners_.end(), [&slot](const TrackedCorner& corner)
                             { return corner.first.clone == slot.id; }))
                unused.push_back(slot.id);
        weighted.belief = removeClones(std::move(weighted.belief), unused);
    }
    return mixture;
}

Mixture MapKeeper::addNew(Mixture mixture, const FrameContext& frame)
{
    const InitializationOptions& rule = options_.initialization;
    const bool undelayed = starting_ || rule.method == InitializationMethod::Undelayed;
    const int have = matchedNow_ + added_ + (undelayed ? 0 : candidates());
    const int wanted = std::min(options_.map.measured_target - have,
                                undelayed ? options_.map.measured_target
                                          : rule.max_candidates - candidates());
    int urgent = undelayed ? wanted : 0;
    if (!undelayed && rule.method == InitializationMethod::Hybrid)
        urgent = std::max(0, rule.hybrid_min_measured - matchedNow_ - added_);
    if (std::max(wanted, urgent) < kWorthDetecting * options_.map.measured_target) return mixture;

    DetectionOptions detection = options_.detection;
    if (matchedNow_ < rule.hybrid_min_measured)  // starving: time does not matter now
        detection.maxCells = detection.gridColumns * detection.gridRows * detection.maxPerCell;
    const auto corners = detectCorners(*frame.image, takenPixels(best(mixture)),
                                       std::max(wanted, urgent), detection, strongest_, rng_);
    const UndelayedPrior prior = priorNow(best(mixture));
    std::vector<Eigen::Vector2d> delayed;
    for (const Corner& corner : corners)
    {
        if (urgent-- > 0)
            mixture = addUndelayedAt(std::move(mixture), corner.uv_px, prior, frame);
        else
            delayed.push_back(corner.uv_px);
    }
    return startCandidates(std::move(mixture), delayed, frame);
}
}  // namespace monoslam
