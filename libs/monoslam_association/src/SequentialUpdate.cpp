// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/SequentialUpdate.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "bestCandidates.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
using camera_state::kOrientation;
using camera_state::kPoseSize;
using camera_state::kSize;

namespace
{
/** How far h may move linearly [px]: after a correction S is a small difference of large numbers,
 *  and feels a change of H more than h does. */
constexpr double kFollowed_px = 0.05;
}  // namespace

SequentialUpdate::SequentialUpdate(Belief predicted, const FrameView& view)
    : belief_(std::move(predicted)), view_(view), P_vv_(belief_.P.topLeftCorner<kSize, kSize>())
{
    for (const LandmarkSlot& slot : belief_.landmarks)
    {
        const auto row = view.linearize(belief_.x, slot);
        if (!row) continue;
        OpenLandmark& landmark = landmarks_.emplace_back();
        landmark.slot = slot;
        landmark.row = *row;
        landmark.row.H_y.rightCols(6 - slot.size()).setZero();
        landmark.P_vy.setZero();
        landmark.P_yy.setZero();
        landmark.P_vy.leftCols(slot.size()) = belief_.P.block(0, slot.offset, kSize, slot.size());
        landmark.P_yy.topLeftCorner(slot.size(), slot.size()) =
            belief_.P.block(slot.offset, slot.offset, slot.size(), slot.size());
        refresh(landmark);
    }
    std::sort(landmarks_.begin(), landmarks_.end(),
              [](const OpenLandmark& a, const OpenLandmark& b) { return a.slot.id < b.slot.id; });
    for (std::size_t i = 0; i < landmarks_.size(); ++i)
        if (landmarks_[i].row.h.allFinite() && positiveDefinite(landmarks_[i].row.S))
            open_.push_back(i);
    W_.resize(belief_.size(), 2 * static_cast<Eigen::Index>(open_.size()));
}

/** S and C of a landmark from its own blocks. */
void SequentialUpdate::refresh(OpenLandmark& landmark) const
{
    PredictedLandmark& row = landmark.row;
    Eigen::Matrix<double, kSize, 2> PHt_v = P_vv_ * row.H_v.transpose();
    PHt_v.noalias() += landmark.P_vy * row.H_y.transpose();
    Eigen::Matrix<double, 6, 2> PHt_y = landmark.P_vy.transpose() * row.H_v.transpose();
    PHt_y.noalias() += landmark.P_yy * row.H_y.transpose();
    Eigen::Matrix2d HPHt = row.H_v * PHt_v;
    HPHt.noalias() += row.H_y * PHt_y;
    row.S = 0.5 * (HPHt + HPHt.transpose()) + row.R;
    landmark.C = PHt_v.topRows<kPoseSize>();
}

bool SequentialUpdate::linearize(std::size_t i)
{
    OpenLandmark& landmark = landmarks_[i];
    const auto row = view_.linearize(belief_.x, landmark.slot);
    if (!row || !row->h.allFinite()) return false;
    landmark.row.h = row->h;
    landmark.row.H_v = row->H_v;
    landmark.row.H_y.leftCols(landmark.slot.size()) = row->H_y.leftCols(landmark.slot.size());
    landmark.moved_px = 0.0;
    refresh(landmark);
    return positiveDefinite(landmark.row.S);
}

void SequentialUpdate::close(std::size_t i)
{
    open_.erase(std::remove(open_.begin(), open_.end(), i), open_.end());
}

/** P_k H' of one landmark, N x 2. */
SequentialUpdate::Columns2 SequentialUpdate::covarianceWith(const OpenLandmark& landmark) const
{
    const PredictedLandmark& row = landmark.row;
    Eigen::Matrix<double, kSize, 2> Hvt = row.H_v.transpose();
    const auto Hyt = row.H_y.leftCols(row.size).transpose();
    Eigen::Matrix<double, Eigen::Dynamic, 2> projected =
        W_.topLeftCorner(kSize, used_).transpose() * Hvt;
    projected.noalias() += W_.block(row.offset, 0, row.size, used_).transpose() * Hyt;

    Hvt.middleRows<4>(kOrientation) = A_q_.transpose() * Hvt.middleRows<4>(kOrientation).eval();
    Columns2 PHt = belief_.P.leftCols<kSize>() * Hvt;
    PHt.noalias() += belief_.P.middleCols(row.offset, row.size) * Hyt;
    PHt.middleRows<4>(kOrientation) = A_q_ * PHt.middleRows<4>(kOrientation).eval();
    PHt.noalias() -= W_.leftCols(used_) * projected;
    return PHt;
}

/** Of the mean, W and P_vv; \return the Jacobian, for the other blocks. */
Eigen::Matrix4d SequentialUpdate::normalizeCamera()
{
    Eigen::Matrix4d J_n_q;
    belief_.x.segment<4>(kOrientation) =
        normalizeQuaternion(belief_.x.segment<4>(kOrientation), &J_n_q);
    A_q_ = J_n_q * A_q_;
    W_.block(kOrientation, 0, 4, used_) = J_n_q * W_.block(kOrientation, 0, 4, used_).eval();
    P_vv_.middleRows<4>(kOrientation) = J_n_q * P_vv_.middleRows<4>(kOrientation).eval();
    P_vv_.middleCols<4>(kOrientation) =
        P_vv_.middleCols<4>(kOrientation).eval() * J_n_q.transpose();
    return J_n_q;
}

/** Blocks and h of an open landmark after the correction w, dx. */
void SequentialUpdate::follow(OpenLandmark& landmark, const Columns2& w,
                              const Eigen::VectorXd& dx) const
{
    PredictedLandmark& row = landmark.row;
    Eigen::Matrix<double, 6, 2> w_y = Eigen::Matrix<double, 6, 2>::Zero();
    w_y.topRows(row.size) = w.middleRows(row.offset, row.size);
    landmark.P_vy.noalias() -= w.topRows<kSize>() * w_y.transpose();
    landmark.P_yy.noalias() -= w_y * w_y.transpose();
    Eigen::Vector2d shift = row.H_v * dx.head<kSize>();
    shift.noalias() += row.H_y.leftCols(row.size) * dx.segment(row.offset, row.size);
    row.h += shift;
    landmark.moved_px += shift.norm();
}

bool SequentialUpdate::correct(std::size_t i, const Eigen::Vector2d& z, const Eigen::Matrix2d& R)
{
    const OpenLandmark& measured = landmarks_[i];
    const Eigen::Matrix2d S = measured.row.S - measured.row.R + R;
    const Eigen::LLT<Eigen::Matrix2d> llt(S);
    if (!positiveDefinite(S) || llt.info() != Eigen::Success) return false;
    Columns2 w = covarianceWith(measured);
    llt.matrixU().solveInPlace<Eigen::OnTheRight>(w);
    const Eigen::Vector2d whitened = llt.matrixL().solve(z - measured.row.h);
    const Eigen::VectorXd dx = w * whitened;
    belief_.x += dx;
    W_.middleCols<2>(used_) = w;
    used_ += 2;
    P_vv_.noalias() -= w.topRows<kSize>() * w.topRows<kSize>().transpose();
    const Eigen::Matrix4d J_n_q = normalizeCamera();
    close(i);
    for (const std::size_t other : open_)
    {
        OpenLandmark& landmark = landmarks_[other];
        follow(landmark, w, dx);
        landmark.P_vy.middleRows<4>(kOrientation) =
            J_n_q * landmark.P_vy.middleRows<4>(kOrientation).eval();
        if (landmark.moved_px > kFollowed_px)
            static_cast<void>(linearize(other));
        else
            refresh(landmark);
    }
    return true;
}

Belief SequentialUpdate::finish() &&
{
    if (used_ == 0) return std::move(belief_);
    Eigen::MatrixXd& P = belief_.P;
    P.middleRows<4>(kOrientation) = A_q_ * P.middleRows<4>(kOrientation).eval();
    P.middleCols<4>(kOrientation) = P.middleCols<4>(kOrientation).eval() * A_q_.transpose();
    P.selfadjointView<Eigen::Lower>().rankUpdate(W_.leftCols(used_), -1.0);
    P.triangularView<Eigen::StrictlyUpper>() = P.transpose();
    normalizeQuaternions(belief_);
    return std::move(belief_);
}
}  // namespace monoslam
