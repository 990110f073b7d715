// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_filter/editBelief.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "monoslam_models/rowPose.h"
#include "resizeBelief.h"

namespace monoslam
{
using camera_state::kPoseSize;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

Belief append(Belief belief, LandmarkId id, LandmarkKind kind, const Eigen::VectorXd& y,
              const Eigen::MatrixXd& P_yx, const Eigen::MatrixXd& P_yy)
{
    const Eigen::Index n = belief.size();
    const Eigen::Index size = landmarkSize(kind);
    if (y.size() != size || P_yx.rows() != size || P_yx.cols() != n || P_yy.rows() != size)
        throw std::invalid_argument("append: sizes of y, P_yx and P_yy disagree");
    grow(belief, size);
    belief.x.tail(size) = y;
    belief.P.bottomLeftCorner(size, n) = P_yx;
    belief.P.topRightCorner(n, size) = P_yx.transpose();
    belief.P.bottomRightCorner(size, size) = 0.5 * (P_yy + P_yy.transpose());
    belief.landmarks.push_back({id, kind, n});
    return belief;
}

Belief addUndelayed(Belief belief, const Camera& camera, const std::vector<NewLandmark>& corners,
                    const UndelayedPrior& prior)
{
    const double variance_px = prior.sigma_px * prior.sigma_px;
    const Eigen::Vector3d R(variance_px, variance_px, prior.sigma_rho * prior.sigma_rho);
    const Vector13d x_v = belief.camera();
    std::vector<std::pair<UndelayedLandmark, Eigen::Matrix<double, 6, 13>>> born;
    Eigen::Index n = belief.size();
    for (const NewLandmark& corner : corners)
    {
        const RowPose row = poseAfter(x_v, rowTime_s(camera, corner.uv_px.y()));
        const auto landmark = initializeUndelayed(camera, row.pose, corner.uv_px, prior.rho0);
        if (!landmark) continue;
        born.emplace_back(*landmark, landmark->J_y_pose * row.J_pose_xv);
        belief.landmarks.push_back({corner.id, LandmarkKind::InverseDepth, n});
        n += inverse_depth::kSize;
    }
    n = belief.size();
    grow(belief, inverse_depth::kSize * static_cast<Eigen::Index>(born.size()));
    for (const auto& [landmark, J_y_xv] : born)
    {
        belief.x.segment<6>(n) = landmark.y;
        const Eigen::Matrix<double, 6, Eigen::Dynamic> P_yx =
            J_y_xv * belief.P.topLeftCorner(camera_state::kSize, n);
        const Matrix6d P_yy = P_yx.leftCols<camera_state::kSize>() * J_y_xv.transpose() +
                              landmark.J_y_z * R.asDiagonal() * landmark.J_y_z.transpose();
        belief.P.block(n, 0, 6, n) = P_yx;
        belief.P.block(0, n, n, 6) = P_yx.transpose();
        belief.P.block<6, 6>(n, n) = 0.5 * (P_yy + P_yy.transpose());
        n += inverse_depth::kSize;
    }
    return belief;
}

std::optional<Belief> addUndelayed(Belief belief, const Camera& camera, LandmarkId id,
                                   const Eigen::Vector2d& uv_px, const UndelayedPrior& prior)
{
    const std::size_t before = belief.landmarks.size();
    belief = addUndelayed(std::move(belief), camera, {{id, uv_px}}, prior);
    if (belief.landmarks.size() == before) return std::nullopt;
    return belief;
}

Belief addTriangulated(Belief belief, LandmarkId id, const Triangulation& triangulation,
                       const FirstView& first, double sigma_px, double sigma_floor)
{
    const auto J_pose = triangulation.J_current.leftCols<kPoseSize>();
    const auto J_first = triangulation.J_first.leftCols<kPoseSize>();
    const auto J_uv = triangulation.J_current.rightCols<2>();
    const auto J_uv0 = triangulation.J_first.rightCols<2>();

    Eigen::MatrixXd P_yx = J_pose * belief.P.topRows<kPoseSize>();
    Eigen::MatrixXd P_yy = sigma_px * sigma_px * (J_uv * J_uv.transpose());
    P_yy += sigma_px * sigma_px * (J_uv0 * J_uv0.transpose());
    const CloneSlot* clone = first.clone >= 0 ? belief.findClone(first.clone) : nullptr;
    if (first.clone >= 0 && !clone)
        throw std::invalid_argument("addTriangulated: the clone is not in the state");
    if (clone)
    {
        P_yx += J_first * belief.P.middleRows<kPoseSize>(clone->offset);
        P_yy += P_yx.middleCols<kPoseSize>(clone->offset) * J_first.transpose();
    }
    else
        P_yy += J_first * first.variance.asDiagonal() * J_first.transpose();
    P_yy += P_yx.leftCols<kPoseSize>() * J_pose.transpose();

    constexpr Eigen::Index rho = inverse_depth::kRho;
    const double floor = sigma_floor * triangulation.y(rho);
    P_yy(rho, rho) = std::max(P_yy(rho, rho), floor * floor);
    return append(std::move(belief), id, LandmarkKind::InverseDepth, triangulation.y, P_yx, P_yy);
}

Belief addPoint(Belief belief, LandmarkId id, const Eigen::Vector3d& p_w,
                const Eigen::Matrix3d& P_p)
{
    const Eigen::MatrixXd P_yx = Eigen::MatrixXd::Zero(3, belief.size());
    return append(std::move(belief), id, LandmarkKind::Point, p_w, P_yx, P_p);
}

Belief removeLandmarks(Belief belief, const std::vector<LandmarkId>& ids)
{
    const auto gone = [&ids](const LandmarkSlot& slot)
    { return std::find(ids.begin(), ids.end(), slot.id) != ids.end(); };
    const auto end = std::remove_if(belief.landmarks.begin(), belief.landmarks.end(), gone);
    if (end == belief.landmarks.end()) return belief;
    belief.landmarks.erase(end, belief.landmarks.end());
    compact(belief);
    return belief;
}

Belief addClone(Belief belief, CloneId id)
{
    const Eigen::Index n = belief.size();
    grow(belief, kPoseSize);
    belief.x.tail<kPoseSize>() = belief.x.head<kPoseSize>();
    belief.P.block(n, 0, kPoseSize, n) = belief.P.block(0, 0, kPoseSize, n);
    belief.P.block(0, n, n, kPoseSize) = belief.P.block(0, 0, n, kPoseSize);
    belief.P.block<kPoseSize, kPoseSize>(n, n) = belief.P.topLeftCorner<kPoseSize, kPoseSize>();
    belief.clones.push_back({id, n});
    return belief;
}

Belief removeClones(Belief belief, const std::vector<CloneId>& ids)
{
    const auto gone = [&ids](const CloneSlot& slot)
    { return std::find(ids.begin(), ids.end(), slot.id) != ids.end(); };
    const auto end = std::remove_if(belief.clones.begin(), belief.clones.end(), gone);
    if (end == belief.clones.end()) return belief;
    belief.clones.erase(end, belief.clones.end());
    compact(belief);
    return belief;
}

Belief convertToPoints(Belief belief, const std::vector<LandmarkId>& ids)
{
    bool changed = false;
    for (const LandmarkId id : ids)
    {
        const Eigen::Index index = belief.find(id);
        if (index < 0) continue;
        LandmarkSlot& slot = belief.landmarks[static_cast<std::size_t>(index)];
        if (slot.kind != LandmarkKind::InverseDepth) continue;
        const Vector6d y = belief.x.segment<inverse_depth::kSize>(slot.offset);
        if (y(inverse_depth::kRho) <= 0.0) continue;
        Matrix36d J_p_y;
        belief.x.segment<3>(slot.offset) = toPoint(y, &J_p_y);
        const Eigen::Matrix<double, Eigen::Dynamic, 6> columns =
            belief.P.middleCols<6>(slot.offset);
        belief.P.middleCols<3>(slot.offset) = columns * J_p_y.transpose();
        const Eigen::Matrix<double, 6, Eigen::Dynamic> rows = belief.P.middleRows<6>(slot.offset);
        belief.P.middleRows<3>(slot.offset) = J_p_y * rows;
        slot.kind = LandmarkKind::Point;
        changed = true;
    }
    if (changed) compact(belief);
    return belief;
}

Belief rescale(Belief belief, double s)
{
    Eigen::VectorXd factor = Eigen::VectorXd::Ones(belief.size());
    factor.segment<3>(camera_state::kPosition).setConstant(s);
    factor.segment<3>(camera_state::kVelocity).setConstant(s);
    for (const auto& slot : belief.clones) factor.segment<3>(slot.offset).setConstant(s);
    for (const auto& slot : belief.landmarks)
    {
        factor.segment<3>(slot.offset).setConstant(s);
        if (slot.kind == LandmarkKind::InverseDepth)
            factor(slot.offset + inverse_depth::kRho) = 1.0 / s;
    }
    belief.x = factor.asDiagonal() * belief.x;
    belief.P = factor.asDiagonal() * belief.P * factor.asDiagonal();
    return belief;
}
}  // namespace monoslam
