// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_models/ConstantVelocity.h"

#include <stdexcept>

#include "monoslam_models/quaternion.h"
#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
namespace
{
using namespace camera_state;

double impulseVariance(double sigma, double dt_s, NoiseForm noise)
{
    const double variance = sigma * sigma;
    return noise == NoiseForm::Density ? variance * dt_s : variance * dt_s * dt_s;
}
}  // namespace

ConstantVelocityOptions ConstantVelocityOptions::from(ConfigSection section)
{
    ConstantVelocityOptions o;
    o.noise = section.get<NoiseForm>(
        "noise", o.noise, {{"density", NoiseForm::Density}, {"per_frame", NoiseForm::PerFrame}});
    o.sigma_accel = section.get("sigma_accel_mps2", o.sigma_accel, kPositive);
    o.sigma_alpha = section.get("sigma_alpha_radps2", o.sigma_alpha, kPositive);
    section.rejectUnknownKeys();
    return o;
}

MotionPrediction predictConstantVelocity(const Vector13d& x_v, double dt_s,
                                         const ConstantVelocityOptions& options)
{
    if (!(dt_s >= 0)) throw std::invalid_argument("constant velocity: time step must be >= 0");

    const Eigen::Vector4d q = x_v.segment<4>(kOrientation);
    const Eigen::Vector3d v = x_v.segment<3>(kVelocity);
    const Eigen::Vector3d omega = x_v.segment<3>(kAngularVelocity);

    Matrix43d J_dq_phi;
    Eigen::Matrix4d J_qp_q, J_qp_dq;
    const Eigen::Vector4d dq = quaternionExp(omega * dt_s, &J_dq_phi);
    const Eigen::Vector4d qp = quaternionProduct(q, dq, &J_qp_q, &J_qp_dq);
    const Matrix43d J_qp_omega = J_qp_dq * J_dq_phi * dt_s;

    MotionPrediction prediction;
    prediction.x_v = x_v;
    prediction.x_v.segment<3>(kPosition) += v * dt_s;
    prediction.x_v.segment<4>(kOrientation) = qp;

    Matrix13d& F = prediction.F;
    F.setIdentity();
    F.block<3, 3>(kPosition, kVelocity).diagonal().setConstant(dt_s);
    F.block<4, 4>(kOrientation, kOrientation) = J_qp_q;
    F.block<4, 3>(kOrientation, kAngularVelocity) = J_qp_omega;

    Eigen::Matrix<double, 13, 6> G = Eigen::Matrix<double, 13, 6>::Zero();
    G.block<3, 3>(kPosition, 0).diagonal().setConstant(dt_s);
    G.block<3, 3>(kVelocity, 0).setIdentity();
    G.block<4, 3>(kOrientation, 3) = J_qp_omega;
    G.block<3, 3>(kAngularVelocity, 3).setIdentity();

    Eigen::Matrix<double, 6, 1> variances;
    variances.head<3>().setConstant(impulseVariance(options.sigma_accel, dt_s, options.noise));
    variances.tail<3>().setConstant(impulseVariance(options.sigma_alpha, dt_s, options.noise));
    prediction.Q = G * variances.asDiagonal() * G.transpose();
    return prediction;
}
}  // namespace monoslam
