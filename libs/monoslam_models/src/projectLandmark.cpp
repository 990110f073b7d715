// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_models/projectLandmark.h"

#include <Eigen/LU>
#include <cmath>

#include "monoslam_models/quaternion.h"
#include "monoslam_models/rowPose.h"

namespace monoslam
{
namespace
{
using namespace camera_state;
using VectorRef = Eigen::Ref<const Eigen::VectorXd>;

/** d = rho (y0 - r) + m or y - r: towards the landmark, in the world, finite at rho = 0. */
Eigen::Vector3d direction(const Eigen::Vector3d& r, LandmarkKind kind, const VectorRef& y,
                          Matrix36d* J_d_y = nullptr)
{
    using namespace inverse_depth;
    if (kind == LandmarkKind::Point)
    {
        if (J_d_y) *J_d_y << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
        return y.head<3>() - r;
    }
    const double rho = y[kRho];
    const Eigen::Vector3d fromCamera = y.head<3>() - r;
    Matrix32d J_m_angles;
    const Eigen::Vector3d m = rayDirection(y[kTheta], y[kPhi], J_d_y ? &J_m_angles : nullptr);
    if (J_d_y) *J_d_y << rho * Eigen::Matrix3d::Identity(), J_m_angles, fromCamera;
    return rho * fromCamera + m;
}

/** The landmark seen from one pose, as if the whole image were taken at once. */
std::optional<ProjectedLandmark> projectAtPose(const Camera& camera, const Vector7d& pose,
                                               LandmarkKind kind, const VectorRef& y)
{
    const Eigen::Vector3d r = pose.head<kOrientation>();
    const Eigen::Vector4d q = pose.tail<4>();
    Matrix36d J_d_y;
    Matrix34d J_hc_q;
    Matrix23d J_h_hc;
    const Eigen::Vector3d d = direction(r, kind, y, &J_d_y);
    const Eigen::Vector3d h_c = rotateInverse(q, d, &J_hc_q);
    const std::optional<Eigen::Vector2d> h = camera.project(h_c, &J_h_hc);
    if (!h) return {};

    const double rho = kind == LandmarkKind::Point ? 1.0 : y[inverse_depth::kRho];
    const Matrix23d J_h_d = J_h_hc * rotationMatrix(q).transpose();

    ProjectedLandmark projected;
    projected.h = *h;
    projected.J_h_xv.leftCols<3>() = -rho * J_h_d;
    projected.J_h_xv.middleCols<4>(kOrientation) = J_h_hc * J_hc_q;
    projected.J_h_xv.rightCols<6>().setZero();
    projected.J_h_y = J_h_d * J_d_y;
    return projected;
}

/** h = g(x, s(h)), s(h) = (h_v / height - 1/2) readout: Newton steps for s, and implicitly
 *  dh/dx = (I - dg/ds ds/dh)^-1 dg/dx. */
std::optional<ProjectedLandmark> projectRolling(const Camera& camera, const Vector13d& x_v,
                                                LandmarkKind kind, const VectorRef& y)
{
    const double readout_s = camera.parameters().readout_s;
    const double perRow_s = readout_s / camera.parameters().height_px;
    double s = 0;
    for (int i = 0; i < 10; ++i)
    {
        const RowPose row = poseAfter(x_v, s);
        std::optional<ProjectedLandmark> g = projectAtPose(camera, row.pose, kind, y);
        if (!g) return {};
        const Eigen::Matrix<double, 2, 7> J_g_pose = g->J_h_xv.leftCols<kPoseSize>();
        const Eigen::Vector2d J_g_s = J_g_pose * row.J_pose_s;
        const double error = s - (g->h.y() * perRow_s - 0.5 * readout_s);
        if (std::abs(error) > 1e-12 * readout_s)
        {
            s -= error / (1 - J_g_s.y() * perRow_s);
            continue;
        }
        Eigen::Matrix2d M = Eigen::Matrix2d::Identity();
        M.col(1) -= J_g_s * perRow_s;
        const Eigen::Matrix2d J_h_g = M.inverse();
        const Eigen::Matrix<double, 2, 13> J_g_xv = J_g_pose * row.J_pose_xv;
        g->J_h_xv = J_h_g * J_g_xv;
        g->J_h_y = (J_h_g * g->J_h_y).eval();
        return g;
    }
    return {};
}
}  // namespace

std::optional<ProjectedLandmark> projectLandmark(const Camera& camera, const Vector13d& x_v,
                                                 LandmarkKind kind, const VectorRef& y)
{
    if (camera.parameters().readout_s > 0) return projectRolling(camera, x_v, kind, y);
    return projectAtPose(camera, x_v.head<kPoseSize>(), kind, y);
}

std::optional<Eigen::Vector2d> projectPixel(const Camera& camera, const Vector13d& x_v,
                                            LandmarkKind kind, const VectorRef& y)
{
    if (camera.parameters().readout_s > 0)
    {
        const std::optional<ProjectedLandmark> projected = projectRolling(camera, x_v, kind, y);
        return projected ? std::optional<Eigen::Vector2d>(projected->h) : std::nullopt;
    }
    const Eigen::Vector3d d = direction(x_v.head<3>(), kind, y);
    return camera.project(rotateInverse(x_v.segment<4>(kOrientation), d));
}
}  // namespace monoslam
