// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_models/triangulate.h"

#include <Eigen/Geometry>
#include <cmath>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
using Eigen::RowVector3d;

constexpr double kPi = 3.14159265358979323846;

/** g = R(q) (undist(u, v), 1), and its Jacobians. */
struct Ray
{
    Eigen::Vector3d g;
    Matrix34d J_g_q;
    Matrix32d J_g_uv;
};

std::optional<Ray> rayOf(const Camera& camera, const View& view)
{
    Eigen::Matrix2d J_xn_uv;
    const std::optional<Eigen::Vector3d> h_c = camera.unproject(view.uv_px, &J_xn_uv);
    if (!h_c) return {};
    const Eigen::Vector4d q = view.pose.tail<4>();
    const Matrix32d J_g_xn = rotationMatrix(q).leftCols<2>();
    Ray ray;
    ray.g = rotate(q, *h_c, &ray.J_g_q);
    ray.J_g_uv = J_g_xn * J_xn_uv;
    return ray;
}

/** Angle between two vectors by atan2, which keeps its digits where acos loses them. */
struct Angle
{
    double angle_rad;
    RowVector3d J_angle_a;  ///< infinite for parallel vectors
    RowVector3d J_angle_b;
};

Angle angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    const double cross = a.cross(b).norm();
    const Eigen::Vector3d a1 = a.normalized(), b1 = b.normalized();
    const double cosine = a1.dot(b1);
    const double sine = cross / (a.norm() * b.norm());
    Angle result;
    result.angle_rad = std::atan2(cross, a.dot(b));
    result.J_angle_a = -(b1 - cosine * a1).transpose() / (a.norm() * sine);
    result.J_angle_b = -(a1 - cosine * b1).transpose() / (b.norm() * sine);
    return result;
}

/** d rho / d(g1, g2, B), by way of alpha, beta, gamma and b. */
struct RhoJacobians
{
    RowVector3d J_rho_g1, J_rho_g2, J_rho_B;
};

RhoJacobians rhoJacobians(const Triangulation& t, double rho, const Eigen::Vector3d& B,
                          const Angle& beta, const Angle& gamma)
{
    const double b = t.baseline;
    const RowVector3d J_b_B = B.transpose() / b;
    const RowVector3d J_gamma_B = -gamma.J_angle_b;  // gamma is the angle with -B

    // rho = sin(alpha) / (b sin(beta)) with alpha = pi - beta - gamma
    const double J_rho_alpha = std::cos(t.alpha_rad) / (b * std::sin(t.beta_rad));
    const double J_rho_beta = -rho / std::tan(t.beta_rad) - J_rho_alpha;
    const double J_rho_gamma = -J_rho_alpha;
    const double J_rho_b = -rho / b;

    RhoJacobians J;
    J.J_rho_g1 = J_rho_beta * beta.J_angle_a;
    J.J_rho_g2 = J_rho_gamma * gamma.J_angle_a;
    J.J_rho_B = J_rho_beta * beta.J_angle_b + J_rho_gamma * J_gamma_B + J_rho_b * J_b_B;
    return J;
}

void fillJacobians(Triangulation& t, const RhoJacobians& J, const Ray& ray1, const Ray& ray2)
{
    using namespace inverse_depth;
    constexpr Eigen::Index kR = 0, kQ = 3, kUv = 7;  // columns (r, q, u, v)

    Matrix23d J_angles_g2;
    t.y.segment<2>(kTheta) = rayAngles(ray2.g, &J_angles_g2);

    t.J_current.setZero();
    t.J_current.block<3, 3>(kAnchor, kR).setIdentity();
    t.J_current.block<2, 4>(kTheta, kQ) = J_angles_g2 * ray2.J_g_q;
    t.J_current.block<2, 2>(kTheta, kUv) = J_angles_g2 * ray2.J_g_uv;
    t.J_current.block<1, 3>(kRho, kR) = J.J_rho_B;
    t.J_current.block<1, 4>(kRho, kQ) = J.J_rho_g2 * ray2.J_g_q;
    t.J_current.block<1, 2>(kRho, kUv) = J.J_rho_g2 * ray2.J_g_uv;

    t.J_first.setZero();
    t.J_first.block<1, 3>(kRho, kR) = -J.J_rho_B;
    t.J_first.block<1, 4>(kRho, kQ) = J.J_rho_g1 * ray1.J_g_q;
    t.J_first.block<1, 2>(kRho, kUv) = J.J_rho_g1 * ray1.J_g_uv;
}
}  // namespace

std::optional<Triangulation> triangulate(const Camera& camera, const View& first,
                                         const View& current)
{
    const std::optional<Ray> ray1 = rayOf(camera, first);
    const std::optional<Ray> ray2 = rayOf(camera, current);
    if (!ray1 || !ray2) return {};

    const Eigen::Vector3d B = current.pose.head<3>() - first.pose.head<3>();
    Triangulation t;
    t.baseline = B.norm();
    const double crossing = ray1->g.cross(B).norm();
    const double currentCrossing = ray2->g.cross(B).norm();
    if (!(crossing > 0 && currentCrossing > 0)) return {};  // no baseline, or moving along a ray

    const Angle beta = angleBetween(ray1->g, B);
    const Angle gamma = angleBetween(ray2->g, -B);
    t.beta_rad = beta.angle_rad;
    t.gamma_rad = gamma.angle_rad;
    t.alpha_rad = kPi - t.beta_rad - t.gamma_rad;
    if (!(t.alpha_rad > 0)) return {};

    const double rho = std::sin(t.alpha_rad) / (t.baseline * std::sin(t.beta_rad));
    t.y.head<3>() = current.pose.head<3>();
    t.y[inverse_depth::kRho] = rho;
    t.epipolarResidual_rad = std::abs(ray1->g.dot(B.cross(ray2->g))) / (crossing * ray2->g.norm());
    fillJacobians(t, rhoJacobians(t, rho, B, beta, gamma), *ray1, *ray2);
    return t;
}
}  // namespace monoslam
