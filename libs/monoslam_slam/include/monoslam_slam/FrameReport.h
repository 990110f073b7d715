// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "monoslam_association/Associator.h"
#include "monoslam_filter/Belief.h"
#include "monoslam_slam/export.h"

namespace monoslam
{
enum class TrackingState
{
    Waiting,  ///< for the metric target; there is no pose yet
    Tracking,
    Degraded,  ///< running, but a self-check of scale, residual or count fails: do not trust blindly
    Lost,      ///< predicting only
};

/** waiting, tracking, degraded, lost. */
[[nodiscard]] MONOSLAM_SLAM_EXPORT std::string name(TrackingState state);

/** CPU time of every stage of one frame, of all threads [ms]; decoding is not among them. */
struct MONOSLAM_SLAM_EXPORT StageTimes
{
    double prepare_ms = 0.0;    ///< pyramid and integral images; the look for a lost map
    double predict_ms = 0.0;    ///< filter prediction
    double search_ms = 0.0;     ///< image search
    double associate_ms = 0.0;  ///< association proper
    double update_ms = 0.0;     ///< predicted measurements and filter update
    double map_ms = 0.0;        ///< deletion, conversion, candidates, new landmarks
    double total_ms = 0.0;

    StageTimes& operator+=(const StageTimes& more);
};

/** What one frame did; everything that the writers write about a frame. */
struct FrameReport
{
    double t_s = 0.0;
    long index = 0;
    TrackingState state = TrackingState::Waiting;
    std::string
        remark;  ///< why degraded, lost or waiting; of the first pose, a doubt about its target
    Vector13d x_v = Vector13d::Zero();
    Matrix13d P_v = Matrix13d::Zero();
    int landmarks = 0;  ///< in the state
    int visible = 0;
    int candidates = 0;  ///< tracked outside the filter
    int matched = 0;
    bool contradicted = false;  ///< by landmarks that are elsewhere: the frame only predicted
    int added = 0;
    int removed = 0;
    double readout_s = 0.0;       ///< of the shutter, given or estimated
    double residualRms_px = 0.0;  ///< of the matched pixels after the update
    std::vector<Association> associations;
    AssociationCounters counters;
    Diversity diversity;  ///< of the beliefs, before the map is revised
    StageTimes times;

    [[nodiscard]] bool hasPose() const { return state != TrackingState::Waiting; }
};

/** 6 x 6 covariance of (dr in the world [m], dtheta in the camera frame [rad]) of a camera state. */
[[nodiscard]] MONOSLAM_SLAM_EXPORT Eigen::Matrix<double, 6, 6> poseCovariance(const Vector13d& x_v,
                                                                              const Matrix13d& P_v);

/** One landmark of the map as it is written. */
struct MapLandmark
{
    LandmarkId id = -1;
    LandmarkKind kind = LandmarkKind::InverseDepth;
    Eigen::VectorXd y;    ///< 6 or 3 numbers
    Eigen::MatrixXd P_y;  ///< their covariance
    int timesSeen = 0;
    long lastSeen = -1;                                 ///< frame index
    bool known = false;                                 ///< one of the metric target's points
    long bornFrame = 0;                                 ///< frame index of its appearance
    Eigen::Vector2d born_px = Eigen::Vector2d::Zero();  ///< its pixel there
};
}  // namespace monoslam
