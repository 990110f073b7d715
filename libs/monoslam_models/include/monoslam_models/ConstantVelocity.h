// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "monoslam_models/export.h"

namespace monoslam
{
class ConfigSection;

/** Offsets in the camera state x_v = (r_wc [m], q_wc, v_w [m/s], omega_c [rad/s]). */
namespace camera_state
{
inline constexpr Eigen::Index kPosition = 0;
inline constexpr Eigen::Index kOrientation = 3;
inline constexpr Eigen::Index kVelocity = 7;
inline constexpr Eigen::Index kAngularVelocity = 10;
inline constexpr Eigen::Index kPoseSize = 7;
inline constexpr Eigen::Index kSize = 13;
}  // namespace camera_state

using Vector7d = Eigen::Matrix<double, 7, 1>;
using Vector13d = Eigen::Matrix<double, 13, 1>;
using Matrix13d = Eigen::Matrix<double, 13, 13>;

/** How the variance of one step's impulses (V, Omega) grows with the step. */
enum class NoiseForm
{
    Density,   ///< Var(V) = sigma_accel^2 dt: the same motion at every frame rate
    PerFrame,  ///< Var(V) = (sigma_accel dt)^2: the papers' form
};

/** Options of the constant-velocity model, ini section [motion]. */
struct MONOSLAM_MODELS_EXPORT ConstantVelocityOptions
{
    NoiseForm noise = NoiseForm::Density;
    double sigma_accel = 1.0;  ///< [m/s^2 sqrt(s)] as a density, [m/s^2] per frame
    double sigma_alpha = 2.0;  ///< [rad/s^2 sqrt(s)] as a density, [rad/s^2] per frame

    static ConstantVelocityOptions from(ConfigSection section);
};

struct MotionPrediction
{
    Vector13d x_v;  ///< f(x_v, dt), quaternion not yet normalised
    Matrix13d F;    ///< df/dx_v
    Matrix13d Q;    ///< G diag(sV^2 I, sO^2 I) G'
};

/** One step of the constant-velocity model with impulse noise n = (V, Omega).
 *
 *      r+ = r + (v + V) dt,  q+ = q (x) exp((omega + Omega) dt),
 *      v+ = v + V,           omega+ = omega + Omega
 *
 * omega is in the camera frame, hence the product on the right (algorithms 1.2, 1.3).
 * \param dt_s  time step, >= 0 [s] */
[[nodiscard]] MONOSLAM_MODELS_EXPORT MotionPrediction
predictConstantVelocity(const Vector13d& x_v, double dt_s, const ConstantVelocityOptions& options);
}  // namespace monoslam
