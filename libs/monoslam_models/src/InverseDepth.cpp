// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_models/InverseDepth.h"

#include <cmath>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
using namespace inverse_depth;

Eigen::Vector3d rayDirection(double theta, double phi, Matrix32d* J_m_angles)
{
    const double st = std::sin(theta), ct = std::cos(theta);
    const double sp = std::sin(phi), cp = std::cos(phi);
    if (J_m_angles) *J_m_angles << cp * ct, -sp * st, 0.0, -cp, -cp * st, -sp * ct;
    return Eigen::Vector3d(cp * st, -sp, cp * ct);
}

Eigen::Vector2d rayAngles(const Eigen::Vector3d& g, Matrix23d* J_angles_g)
{
    const double n2 = g.x() * g.x() + g.z() * g.z();
    const double n = std::sqrt(n2);
    if (J_angles_g)
    {
        const double M = n2 + g.y() * g.y();
        *J_angles_g << g.z() / n2, 0.0, -g.x() / n2,  //
            g.x() * g.y() / (M * n), -n / M, g.y() * g.z() / (M * n);
    }
    return Eigen::Vector2d(std::atan2(g.x(), g.z()), std::atan2(-g.y(), n));
}

Eigen::Vector3d toPoint(const Vector6d& y, Matrix36d* J_p_y)
{
    const double rho = y[kRho];
    Matrix32d J_m_angles;
    const Eigen::Vector3d m = rayDirection(y[kTheta], y[kPhi], &J_m_angles);
    if (J_p_y)
    {
        J_p_y->leftCols<3>().setIdentity();
        J_p_y->middleCols<2>(kTheta) = J_m_angles / rho;
        J_p_y->col(kRho) = -m / (rho * rho);
    }
    return y.head<3>() + m / rho;
}

double linearityIndex(const Vector6d& y, double sigma_rho, const Eigen::Vector3d& r_wc)
{
    const double rho = y[kRho];
    const double sigma_d = sigma_rho / (rho * rho);
    const Eigen::Vector3d m = rayDirection(y[kTheta], y[kPhi]);
    const Eigen::Vector3d h = toPoint(y) - r_wc;
    const double d1 = h.norm();
    const double cosAlpha = m.dot(h) / d1;
    return 4.0 * sigma_d * std::abs(cosAlpha) / d1;
}

std::optional<UndelayedLandmark> initializeUndelayed(const Camera& camera, const Vector7d& pose,
                                                     const Eigen::Vector2d& uv_px, double rho0)
{
    Eigen::Matrix2d J_xn_uv;
    const std::optional<Eigen::Vector3d> h_c = camera.unproject(uv_px, &J_xn_uv);
    if (!h_c) return {};

    const Eigen::Vector4d q = pose.tail<4>();
    Matrix34d J_g_q;
    Matrix23d J_angles_g;
    const Eigen::Vector3d g = rotate(q, *h_c, &J_g_q);
    const Matrix32d J_g_xn = rotationMatrix(q).leftCols<2>();

    UndelayedLandmark landmark;
    landmark.y << pose.head<3>(), rayAngles(g, &J_angles_g), rho0;

    landmark.J_y_pose.setZero();
    landmark.J_y_pose.block<3, 3>(kAnchor, 0).setIdentity();
    landmark.J_y_pose.block<2, 4>(kTheta, 3) = J_angles_g * J_g_q;

    landmark.J_y_z.setZero();
    landmark.J_y_z.block<2, 2>(kTheta, 0) = J_angles_g * J_g_xn * J_xn_uv;
    landmark.J_y_z(kRho, 2) = 1.0;
    return landmark;
}
}  // namespace monoslam
