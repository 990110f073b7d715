// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_slam/FrameReport.h"

#include "monoslam_models/quaternion.h"

namespace monoslam
{
std::string name(TrackingState state)
{
    switch (state)
    {
        case TrackingState::Waiting:
            return "waiting";
        case TrackingState::Tracking:
            return "tracking";
        case TrackingState::Degraded:
            return "degraded";
        case TrackingState::Lost:
            return "lost";
    }
    return "unknown";
}

Eigen::Matrix<double, 6, 6> poseCovariance(const Vector13d& x_v, const Matrix13d& P_v)
{
    // dtheta = 2 vec(q* (x) q_true): rows 1 to 3 of QL(q*) = QL(q)'.
    const Eigen::Vector4d q = x_v.segment<4>(camera_state::kOrientation);
    Eigen::Matrix4d QL;
    (void)quaternionProduct(quaternionConjugate(q), q, nullptr, &QL);
    Eigen::Matrix<double, 6, 7> T = Eigen::Matrix<double, 6, 7>::Zero();
    T.topLeftCorner<3, 3>().setIdentity();
    T.bottomRightCorner<3, 4>() = 2.0 * QL.bottomRows<3>();
    const Eigen::Matrix<double, 6, 6> C = T * P_v.topLeftCorner<7, 7>() * T.transpose();
    return 0.5 * (C + C.transpose());
}

StageTimes& StageTimes::operator+=(const StageTimes& more)
{
    prepare_ms += more.prepare_ms;
    predict_ms += more.predict_ms;
    search_ms += more.search_ms;
    associate_ms += more.associate_ms;
    update_ms += more.update_ms;
    map_ms += more.map_ms;
    total_ms += more.total_ms;
    return *this;
}
}  // namespace monoslam
