// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "monoslam_eval/JointPairs.h"
#include "monoslam_filter/editBelief.h"
#include "monoslam_filter/ekf.h"
#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kRad_deg = 3.14159265358979323846 / 180.0;
constexpr double kNearest_m = 0.5, kFarthest_m = 5.0;
constexpr double kBorder_px = 20.0;
constexpr int kFrames = 8;
constexpr double kStep_m = 0.03;  ///< of the camera, a frame

double uniform(double least, double most, std::mt19937& rng)
{
    return std::uniform_real_distribution<double>(least, most)(rng);
}

Eigen::VectorXd normalVector(Eigen::Index n, std::mt19937& rng)
{
    std::normal_distribution<double> normal;
    return Eigen::VectorXd::NullaryExpr(n, [&] { return normal(rng); });
}

Camera makeCamera()
{
    CameraParameters parameters;
    parameters.fx_px = parameters.fy_px = 400.0;
    return Camera(parameters);
}

Vector13d cameraAt(const Eigen::Vector3d& r_wc)
{
    Vector13d x_v = Vector13d::Zero();
    x_v.head<3>() = r_wc;
    x_v(camera_state::kOrientation) = 1.0;
    return x_v;
}

/** A point that all of the views see, log-uniform in distance from the last. */
Eigen::Vector3d drawPoint(const Camera& camera, const std::vector<Vector13d>& views,
                          std::mt19937& rng)
{
    const CameraParameters& p = camera.parameters();
    for (;;)
    {
        const Eigen::Vector2d uv(uniform(0.0, p.width_px, rng), uniform(0.0, p.height_px, rng));
        const double distance_m =
            kNearest_m * std::pow(kFarthest_m / kNearest_m, uniform(0.0, 1.0, rng));
        const Eigen::Vector3d ray((uv.x() - p.cx_px) / p.fx_px, (uv.y() - p.cy_px) / p.fy_px, 1.0);
        const Eigen::Vector3d point = views.back().head<3>() + distance_m * ray.normalized();
        bool seen = true;
        for (const Vector13d& x_v : views)
        {
            const auto pixel = projectPixel(camera, x_v, LandmarkKind::Point, point);
            seen = seen && pixel && (pixel->array() > kBorder_px).all() &&
                   pixel->x() < p.width_px - kBorder_px && pixel->y() < p.height_px - kBorder_px;
        }
        if (seen) return point;
    }
}

/** P_v of a pose with correlated errors of position and orientation. */
Matrix13d drawPoseCovariance(const Vector13d& x_v, std::mt19937& rng)
{
    Eigen::Matrix<double, 6, 6> A = normalVector(36, rng).reshaped(6, 6);
    for (Eigen::Index i = 0; i < 6; ++i)
        A.row(i) *= (i < 3 ? uniform(0.02, 0.05, rng) : uniform(0.7, 1.4, rng) * kRad_deg) /
                    A.row(i).norm();
    const Eigen::Vector4d q = x_v.segment<4>(camera_state::kOrientation);
    Eigen::Matrix<double, 13, 6> T = Eigen::Matrix<double, 13, 6>::Zero();
    T.topLeftCorner<3, 3>().setIdentity();
    for (Eigen::Index i = 0; i < 3; ++i)  // q (x) (1, phi / 2)
        T.block<4, 1>(camera_state::kOrientation, 3 + i) =
            0.5 * quaternionProduct(q, Eigen::Vector4d::Unit(i + 1));
    return T * A * A.transpose() * T.transpose();
}

JointPrior independentPrior(Eigen::Index landmarks, std::mt19937& rng)
{
    const Camera camera = makeCamera();
    const Vector13d x_v = cameraAt(Eigen::Vector3d::Zero());
    Eigen::MatrixXd J(2 * landmarks, 13);
    JointPrior prior;
    prior.S = Eigen::MatrixXd::Identity(2 * landmarks, 2 * landmarks);
    for (Eigen::Index j = 0; j < landmarks; ++j)
    {
        const Eigen::Vector3d point = drawPoint(camera, {x_v}, rng);
        const Eigen::Vector3d view = kFrames * kStep_m * normalVector(3, rng).normalized();
        const Eigen::Vector3d sigma_m = uniform(0.02, 0.15, rng) * (point - view);
        const ProjectedLandmark seen =
            projectLandmark(camera, x_v, LandmarkKind::Point, point).value();
        J.middleRows<2>(2 * j) = seen.J_h_xv;
        const Eigen::Vector2d spread = seen.J_h_y.leftCols<3>() * sigma_m;
        prior.S.block<2, 2>(2 * j, 2 * j) += spread * spread.transpose();
        prior.pixels.push_back(seen.h);
    }
    prior.S += J * drawPoseCovariance(x_v, rng) * J.transpose();
    return prior;
}

struct Birth
{
    Eigen::Vector3d point;
    int frame = 0;
};

Belief addBorn(Belief belief, const Camera& camera, const std::vector<Birth>& births, int frame)
{
    const Vector13d view = belief.camera();
    for (std::size_t j = 0; j < births.size(); ++j)
    {
        if (births[j].frame != frame) continue;
        const double rho = 1.0 / (births[j].point - view.head<3>()).norm();
        const auto uv = projectPixel(camera, view, LandmarkKind::Point, births[j].point);
        belief = addUndelayed(std::move(belief), camera, static_cast<LandmarkId>(j), uv.value(),
                              {rho, 0.3 * rho, VisibilityOptions{}.sigma_px})
                     .value();
    }
    return belief;
}

/** The means stay: every pixel is where it was predicted. */
Belief updateAll(Belief belief, const Camera& camera)
{
    const Prediction prediction = predictMeasurements(belief, camera, {});
    std::vector<PixelMeasurement> pixels;
    for (Eigen::Index row = 0; row < prediction.count(); ++row)
    {
        const PredictedLandmark& seen = prediction.rows[static_cast<std::size_t>(row)];
        pixels.push_back({row, seen.h, seen.R});
    }
    return ekfUpdate(std::move(belief), prediction, pixels);
}

JointPrior filterPrior(Eigen::Index landmarks, std::mt19937& rng)
{
    const Camera camera = makeCamera();
    const Eigen::Vector3d step_m = kStep_m * normalVector(3, rng).normalized();
    Vector13d x_v = cameraAt(Eigen::Vector3d::Zero());
    x_v.segment<3>(camera_state::kVelocity) = step_m;
    std::vector<Birth> births;
    std::uniform_int_distribution<int> frames(0, kFrames - 1);
    for (Eigen::Index j = 0; j < landmarks; ++j)
        births.push_back({drawPoint(camera, {x_v, cameraAt(kFrames * step_m)}, rng), frames(rng)});

    // A frame is the unit of time, so that an impulse is one frame's noise.
    const ConstantVelocityOptions motion{NoiseForm::PerFrame, uniform(0.02, 0.05, rng),
                                         uniform(0.7, 1.4, rng) * kRad_deg};
    Belief belief = addBorn(Belief::ofCamera(x_v, Matrix13d::Zero()), camera, births, 0);
    for (int frame = 1; frame < kFrames; ++frame)
    {
        belief = updateAll(ekfPredict(std::move(belief), motion, 1.0), camera);
        belief = addBorn(std::move(belief), camera, births, frame);
    }
    belief = ekfPredict(std::move(belief), motion, 1.0);
    const Prediction prediction = predictMeasurements(belief, camera, {});
    JointPrior prior{prediction.HPHt, {}};
    for (Eigen::Index row = 0; row < prediction.count(); ++row)
    {
        const PredictedLandmark& seen = prediction.rows[static_cast<std::size_t>(row)];
        prior.S.block<2, 2>(2 * row, 2 * row) += seen.R;
        prior.pixels.push_back(seen.h);
    }
    return prior;
}
}  // namespace

JointPrior drawJointPrior(Eigen::Index landmarks, CovarianceKind kind, std::mt19937& rng)
{
    return kind == CovarianceKind::Filter ? filterPrior(landmarks, rng)
                                          : independentPrior(landmarks, rng);
}
}  // namespace monoslam
