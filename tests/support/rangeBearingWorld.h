// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement3D.h>
#include <mrpt/obs/CObservationBearingRange.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/poses/CPose3D.h>
#include <mrpt/poses/CPose3DQuatPDFGaussian.h>

#include <cmath>
#include <vector>

namespace monoslam::test
{
/** Landmarks and a robot that sees all of them without noise, as kf-slam's rawlogs have it. */
class RangeBearingWorld
{
   public:
    explicit RangeBearingWorld(std::vector<mrpt::math::TPoint3D> landmarks)
        : landmarks_(std::move(landmarks))
    {
    }

    /** Looks along the heading of that yaw [rad]; the odometry does not tell. */
    void turnTo(double yaw_rad) { robot_ = mrpt::poses::CPose3D(0, 0, 0, yaw_rad, 0, 0); }
    /** Forward by that much, as the odometry tells [m]. */
    void move(double forward_m)
    {
        increment_ = mrpt::poses::CPose3D(forward_m, 0, 0, 0.01, 0, 0);
        robot_ = robot_ + increment_;
        moved_ = true;
    }

    [[nodiscard]] double distanceFrom(const mrpt::poses::CPose3DQuat& pose) const
    {
        return mrpt::poses::CPose3D(pose).distanceTo(robot_);
    }

    [[nodiscard]] mrpt::obs::CObservationBearingRange::Ptr observe() const
    {
        auto sensor = mrpt::obs::CObservationBearingRange::Create();
        sensor->maxSensorDistance = 20.0F;
        sensor->fieldOfView_yaw = sensor->fieldOfView_pitch = 7.0F;
        for (const auto& landmark : landmarks_) sensor->sensedData.push_back(measure(landmark));
        return sensor;
    }

    [[nodiscard]] mrpt::obs::CObservationBearingRange::TMeasurement measure(
        const mrpt::math::TPoint3D& landmark, int id = -1) const
    {
        double range = 0.0, yaw = 0.0, pitch = 0.0;
        robot_.sphericalCoordinates(landmark, range, yaw, pitch);
        mrpt::obs::CObservationBearingRange::TMeasurement m;
        m.range = static_cast<float>(range);
        m.yaw = static_cast<float>(yaw);
        m.pitch = static_cast<float>(pitch);
        m.landmarkID = id;
        return m;
    }

    template <class Slam>
    void step(Slam& slam, const mrpt::obs::CObservationBearingRange::Ptr& sensor) const
    {
        auto action = mrpt::obs::CActionCollection::Create();
        if (moved_)
        {
            mrpt::obs::CActionRobotMovement3D movement;
            movement.poseChange.mean = increment_;
            movement.poseChange.cov.setDiagonal(1e-4);
            action->insert(movement);
        }
        auto frame = mrpt::obs::CSensoryFrame::Create();
        frame->insert(sensor);
        slam.processActionObservation(action, frame);
    }
    template <class Slam>
    void step(Slam& slam) const
    {
        step(slam, observe());
    }

   private:
    mrpt::poses::CPose3D robot_, increment_;
    std::vector<mrpt::math::TPoint3D> landmarks_;
    bool moved_ = false;
};

/** Largest difference between P and its transpose. */
template <class Slam>
double asymmetry(const Slam& slam)
{
    mrpt::poses::CPose3DQuatPDFGaussian pose;
    std::vector<mrpt::math::TPoint3D> landmarks;
    std::map<unsigned int, mrpt::maps::CLandmark::TLandmarkID> ids;
    mrpt::math::CVectorDouble x;
    mrpt::math::CMatrixDouble P;
    slam.getCurrentState(pose, landmarks, ids, x, P);
    return (P.asEigen() - P.asEigen().transpose()).cwiseAbs().maxCoeff();
}
}  // namespace monoslam::test
