// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "monoslam_models/projectLandmark.h"
#include "monoslam_models/quaternion.h"
#include "randomValues.h"

namespace monoslam
{
/** Camera state with a quaternion of any length, and moderate velocities. */
inline Vector13d randomState(std::mt19937& rng)
{
    Vector13d x_v;
    x_v << uniformVector<3>(rng, 1.0), uniform(rng, 0.7, 1.4) * randomQuaternion(rng),
        uniformVector<3>(rng, 1.0), uniformVector<3>(rng, 1.0);
    return x_v;
}

/** A landmark that the camera sees at a pixel; an inverse-depth one is anchored nearby. */
inline Eigen::VectorXd landmarkAt(std::mt19937& rng, const Camera& camera, const Vector13d& x_v,
                                  LandmarkKind kind, const Eigen::Vector2d& uv)
{
    const Eigen::Vector3d ray =
        rotate(x_v.segment<4>(camera_state::kOrientation), *camera.unproject(uv));
    const Eigen::Vector3d p = x_v.head<3>() + uniform(rng, 0.8, 5.0) * ray.normalized();
    if (kind == LandmarkKind::Point) return p;
    const Eigen::Vector3d anchor = x_v.head<3>() + uniformVector<3>(rng, 0.3);
    Vector6d y;
    y << anchor, rayAngles(p - anchor), 1 / (p - anchor).norm();
    return y;
}
}  // namespace monoslam
