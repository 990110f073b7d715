// SPDX-License-Identifier: BSD-3-Clause
#include "LostMaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "LandmarkFinder.h"
#include "monoslam_filter/editBelief.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr std::size_t kMostMaps = 3;
constexpr std::size_t kLeastLandmarks = 12;  ///< of known depth: fewer are no map to come back to
constexpr std::size_t kLeastAgreeing = 6;
constexpr double kDepthKnown = 0.3;  ///< sigma_rho / rho
constexpr double kAgree_px = 4.0;
constexpr double kSigma_px = 2.0;  ///< of a corner of the coarser scales
constexpr int kDraws = 1000;
constexpr double kSure = 0.999;
constexpr double kTurn_rad =
    0.5;  ///< of a camera of unknown orientation, near the one it is linearised at

bool depthKnown(const Belief& belief, const LandmarkSlot& slot)
{
    if (slot.kind == LandmarkKind::Point) return true;
    const Eigen::Index at = slot.offset + inverse_depth::kRho;
    return std::sqrt(std::max(belief.P(at, at), 0.0)) < kDepthKnown * belief.x(at);
}

std::optional<CameraPose> ransacPose(const SeenPoints& seen, const Camera& camera,
                                     std::vector<int>& agreeing)
{
    std::vector<cv::Point3d> points;
    std::vector<cv::Point2d> rays;
    for (std::size_t i = 0; i < seen.points_m.size(); ++i)
    {
        const auto ray = camera.unproject(seen.pixels_px[i]);
        if (!ray) return std::nullopt;
        rays.emplace_back(ray->x(), ray->y());
        points.emplace_back(seen.points_m[i].x(), seen.points_m[i].y(), seen.points_m[i].z());
    }
    cv::Vec3d phi;
    cv::Vec3d t;
    const auto threshold = static_cast<float>(kAgree_px / camera.parameters().fx_px);
    if (!cv::solvePnPRansac(points, rays, cv::Matx33d::eye(), cv::noArray(), phi, t, false, kDraws,
                            threshold, kSure, agreeing, cv::SOLVEPNP_AP3P))
        return std::nullopt;
    const Eigen::Vector3d phi_cw(phi.val);
    const Eigen::Vector3d t_cw(t.val);
    if (!phi_cw.allFinite() || !t_cw.allFinite()) return std::nullopt;
    const Eigen::Matrix3d R_wc = rotationMatrix(quaternionExp(phi_cw)).transpose();
    return CameraPose{R_wc, -R_wc * t_cw};
}

SeenPoints only(const SeenPoints& seen, const std::vector<int>& chosen)
{
    SeenPoints some;
    for (const int i : chosen)
    {
        some.points_m.push_back(seen.points_m[static_cast<std::size_t>(i)]);
        some.pixels_px.push_back(seen.pixels_px[static_cast<std::size_t>(i)]);
        some.sigmas_px.push_back(seen.sigmas_px[static_cast<std::size_t>(i)]);
    }
    return some;
}

std::optional<MapSighting> sight(const LostMap& map, const DescribedCorners& seen,
                                 const Camera& camera)
{
    MapSighting sighting;
    SeenPoints points;
    for (const CornerMatch& match : matchCorners(map.described, seen))
    {
        const LandmarkSlot& slot = map.belief.landmarks[match.index];
        if (!camera.unproject(match.uv_px)) continue;
        sighting.ids.push_back(slot.id);
        points.points_m.push_back(landmarkPoint(map.belief, slot));
        points.pixels_px.push_back(match.uv_px);
        points.sigmas_px.push_back(kSigma_px);
    }
    if (sighting.ids.size() < kLeastAgreeing) return std::nullopt;
    std::vector<int> agreeing;
    const auto pose = ransacPose(points, camera, agreeing);
    if (!pose || agreeing.size() < kLeastAgreeing) return std::nullopt;
    points = only(points, agreeing);
    const auto refined = refinePose(points, camera, *pose);
    if (!refined) return std::nullopt;
    sighting.pose = *refined;
    sighting.uv_px = points.pixels_px;
    std::vector<LandmarkId> ids;
    for (const int i : agreeing) ids.push_back(sighting.ids[static_cast<std::size_t>(i)]);
    sighting.ids = std::move(ids);
    return sighting;
}

/** A camera independent of the map, of unknown place. */
void forgetCamera(Belief& belief, const CameraPose& pose, const Belief& resting, double distance)
{
    const Eigen::Vector4d q_wc = quaternionFromMatrix(pose.R_wc);
    belief.x.head<3>() = pose.r_wc;
    belief.x.segment<4>(camera_state::kOrientation) = q_wc;
    belief.x.segment<6>(camera_state::kVelocity) = resting.x.tail<6>();
    belief.P.topRows<camera_state::kSize>().setZero();
    belief.P.leftCols<camera_state::kSize>().setZero();
    belief.P.topLeftCorner<3, 3>().diagonal().setConstant(distance * distance);
    Eigen::Matrix4d QL;
    (void)quaternionProduct(q_wc, Eigen::Vector4d::UnitX(), nullptr, &QL);
    const Eigen::Matrix<double, 4, 3> J_q_theta = 0.5 * QL.rightCols<3>();
    belief.P.block<4, 4>(camera_state::kOrientation, camera_state::kOrientation) =
        kTurn_rad * kTurn_rad * J_q_theta * J_q_theta.transpose();
    belief.P.block<6, 6>(camera_state::kVelocity, camera_state::kVelocity) =
        resting.P.bottomRightCorner<6, 6>();
}
}  // namespace

void LostMaps::keep(LostMap map, const LastView& last)
{
    std::size_t known = 0;
    for (std::size_t l = 0; l < map.belief.landmarks.size(); ++l)
    {
        const LandmarkSlot& slot = map.belief.landmarks[l];
        const auto record = map.records.find(slot.id);
        if (record == map.records.end() || !depthKnown(map.belief, slot)) continue;
        const Appearance& born = record->second.born;
        describePlace(*born.image, born.uv_px, l, map.described);
        for (const auto& [id, uv_px] : last.pixels)
            if (id == slot.id) describePlace(*last.image, uv_px, l, map.described);
        ++known;
    }
    if (known < kLeastLandmarks) return;
    if (maps_.size() == kMostMaps) maps_.erase(maps_.begin() + 1);
    maps_.push_back(std::make_unique<LostMap>(std::move(map)));
}

LostMap LostMaps::takeOut(std::size_t map)
{
    LostMap found = std::move(*maps_.at(map));
    maps_.erase(maps_.begin() + static_cast<std::ptrdiff_t>(map));
    if (!found.guessed) maps_.clear();
    return found;
}

std::vector<MapSighting> LostMaps::find(const PreparedImage& image, const Camera& camera,
                                        bool guessed) const
{
    const DescribedCorners seen = describeImage(image);
    std::vector<MapSighting> sightings;
    for (std::size_t m = 0; m < maps_.size(); ++m)
    {
        if (maps_[m]->guessed && !guessed) continue;
        auto sighting = sight(*maps_[m], seen, camera);
        if (!sighting) continue;
        sighting->map = m;
        sightings.push_back(std::move(*sighting));
    }
    return sightings;
}

Belief placeInMap(const LostMap& map, const MapSighting& sighting, const Camera& camera,
                  const Belief& resting, const FilterEngine& engine)
{
    Belief belief = map.belief;
    std::vector<CloneId> clones;
    for (const CloneSlot& clone : belief.clones) clones.push_back(clone.id);
    belief = removeClones(std::move(belief), clones);
    forgetCamera(belief, sighting.pose, resting, 1.0 / map.rho0);
    const auto place = [&sighting](LandmarkId id)
    { return std::find(sighting.ids.begin(), sighting.ids.end(), id) - sighting.ids.begin(); };
    const auto count = static_cast<std::ptrdiff_t>(sighting.ids.size());
    const Prediction prediction = predictMeasurements(
        belief, camera, {0.0, kSigma_px},
        [&](Eigen::Index l)
        { return place(belief.landmarks[static_cast<std::size_t>(l)].id) < count; });
    std::vector<PixelMeasurement> pixels;
    for (const PredictedLandmark& row : prediction.rows)
        pixels.push_back({static_cast<Eigen::Index>(pixels.size()),
                          sighting.uv_px[static_cast<std::size_t>(place(row.id))], row.R});
    return engine.update(std::move(belief), prediction, pixels, nullptr);
}
}  // namespace monoslam
