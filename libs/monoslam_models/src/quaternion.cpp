// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_models/quaternion.h"

#include <Eigen/Geometry>
#include <cmath>

namespace monoslam
{
namespace
{
Eigen::Matrix3d skew(const Eigen::Vector3d& a)
{
    Eigen::Matrix3d a_x;
    a_x << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return a_x;
}
}  // namespace

Eigen::Matrix3d rotationMatrix(const Eigen::Vector4d& q)
{
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    Eigen::Matrix3d R;
    R << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
        2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
        2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
    return R;
}

Eigen::Vector4d quaternionFromMatrix(const Eigen::Matrix3d& R_wc)
{
    const Eigen::Quaterniond rotation = Eigen::Quaterniond(R_wc).normalized();
    const Eigen::Vector4d q(rotation.w(), rotation.x(), rotation.y(), rotation.z());
    return q[0] < 0 ? Eigen::Vector4d(-q) : q;
}

Eigen::Vector4d quaternionProduct(const Eigen::Vector4d& q, const Eigen::Vector4d& p,
                                  Eigen::Matrix4d* J_qp_q, Eigen::Matrix4d* J_qp_p)
{
    Eigen::Matrix4d QL;
    QL << q[0], -q[1], -q[2], -q[3],  //
        q[1], q[0], -q[3], q[2],      //
        q[2], q[3], q[0], -q[1],      //
        q[3], -q[2], q[1], q[0];
    if (J_qp_q)
        *J_qp_q << p[0], -p[1], -p[2], -p[3],  //
            p[1], p[0], p[3], -p[2],           //
            p[2], -p[3], p[0], p[1],           //
            p[3], p[2], -p[1], p[0];
    if (J_qp_p) *J_qp_p = QL;
    return QL * p;
}

Eigen::Vector4d quaternionConjugate(const Eigen::Vector4d& q)
{
    return Eigen::Vector4d(q[0], -q[1], -q[2], -q[3]);
}

Eigen::Vector4d quaternionExp(const Eigen::Vector3d& phi, Matrix43d* J_q_phi)
{
    // exp = (cos(t/2), s phi) with s = sin(t/2)/t, and ds/dphi = c phi'; series below t = 1e-3,
    // where the quotient of c would lose its digits
    const double t2 = phi.squaredNorm();
    const double t = std::sqrt(t2);
    const bool isSmall = t < 1e-3;
    const double s = isSmall ? 0.5 - t2 / 48 + t2 * t2 / 3840 : std::sin(t / 2) / t;
    const double c = isSmall ? -1.0 / 24 + t2 / 960 : (0.5 * std::cos(t / 2) - s) / t2;
    if (J_q_phi)
    {
        J_q_phi->row(0) = -0.5 * s * phi.transpose();
        J_q_phi->bottomRows<3>() = c * phi * phi.transpose();
        J_q_phi->bottomRows<3>().diagonal().array() += s;
    }
    Eigen::Vector4d q;
    q << std::cos(t / 2), s * phi;
    return q;
}

Eigen::Vector3d quaternionLog(const Eigen::Vector4d& q)
{
    const double sign = q[0] < 0 ? -1.0 : 1.0;  // q and -q are one rotation: take the shorter way
    const double w = sign * q[0];
    const Eigen::Vector3d n = sign * q.tail<3>();
    const double sine = n.norm();
    return sine < 1e-12 ? Eigen::Vector3d(2 / w * n)
                        : Eigen::Vector3d(2 * std::atan2(sine, w) / sine * n);
}

Eigen::Vector3d rotate(const Eigen::Vector4d& q, const Eigen::Vector3d& a, Matrix34d* J_Ra_q)
{
    if (J_Ra_q)
    {
        const double w = q[0];
        const Eigen::Vector3d n = q.tail<3>();
        J_Ra_q->col(0) = 2 * (w * a + n.cross(a));
        J_Ra_q->rightCols<3>() = 2 * (n * a.transpose() - a * n.transpose() - w * skew(a));
        J_Ra_q->rightCols<3>().diagonal().array() += 2 * n.dot(a);
    }
    return rotationMatrix(q) * a;
}

Eigen::Vector3d rotateInverse(const Eigen::Vector4d& q, const Eigen::Vector3d& a,
                              Matrix34d* J_RTa_q)
{
    const Eigen::Vector3d RTa = rotate(quaternionConjugate(q), a, J_RTa_q);
    if (J_RTa_q) J_RTa_q->rightCols<3>() *= -1;
    return RTa;
}

Eigen::Vector4d normalizeQuaternion(const Eigen::Vector4d& q, Eigen::Matrix4d* J_n_q)
{
    const double length = q.norm();
    const Eigen::Vector4d unit = q / length;
    if (J_n_q) *J_n_q = (Eigen::Matrix4d::Identity() - unit * unit.transpose()) / length;
    return unit;
}
}  // namespace monoslam
