// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "monoslam_filter/editBelief.h"
#include "monoslam_filter/ekf.h"
#include "randomValues.h"

namespace monoslam
{
struct RandomBeliefOptions
{
    int inverseDepths = 10;
    int points = 0;
    bool clone = false;
};

inline Matrix13d cameraCovariance(const Vector13d& x_v)
{
    Matrix13d P_v = Matrix13d::Zero();
    P_v.diagonal().head<3>().setConstant(1e-4);
    const Eigen::Vector4d q = x_v.segment<4>(camera_state::kOrientation);
    P_v.block<4, 4>(3, 3) = 1e-4 * (Eigen::Matrix4d::Identity() - q * q.transpose());
    P_v.diagonal().segment<3>(camera_state::kVelocity).setConstant(0.01);
    P_v.diagonal().segment<3>(camera_state::kAngularVelocity).setConstant(0.01);
    return P_v;
}

/** A camera somewhere that sees landmarks all over its image and has then moved for a frame, so
 *  that everything is correlated with everything. */
inline Belief randomBelief(std::mt19937& rng, const Camera& camera,
                           const RandomBeliefOptions& options)
{
    Vector13d x_v;
    x_v << uniformVector<3>(rng, 1.0), randomQuaternion(rng), uniformVector<3>(rng, 0.3),
        uniformVector<3>(rng, 0.2);
    Belief belief = Belief::ofCamera(x_v, cameraCovariance(x_v));
    LandmarkId id = 0;
    for (; id < options.inverseDepths + options.points; ++id)
    {
        const Eigen::Vector2d uv(uniform(rng, 60.0, 580.0), uniform(rng, 60.0, 420.0));
        belief = addUndelayed(std::move(belief), camera, id, uv, {uniform(rng, 0.3, 1.0), 0.1, 1.0})
                     .value();
        if (id < options.points) belief = convertToPoints(std::move(belief), {id});
    }
    if (options.clone) belief = addClone(std::move(belief), 7);
    return ekfPredict(std::move(belief), {}, 1.0 / 30.0);
}

/** Every predicted pixel, a little off, with noise that differs from row to row. */
inline std::vector<PixelMeasurement> randomPixels(std::mt19937& rng, const Prediction& prediction)
{
    std::vector<PixelMeasurement> pixels;
    for (Eigen::Index row = 0; row < prediction.count(); ++row)
    {
        const Eigen::Matrix2d A =
            Eigen::Matrix2d::Identity() * uniform(rng, 0.5, 1.5) + 0.2 * Eigen::Matrix2d::Ones();
        const Eigen::Vector2d h = prediction.rows[static_cast<std::size_t>(row)].h;
        pixels.push_back({row, h + uniformVector<2>(rng, 2.0), A * A.transpose()});
    }
    return pixels;
}

inline double largestDifference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    return (a - b).cwiseAbs().maxCoeff();
}
}  // namespace monoslam
