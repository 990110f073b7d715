// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/predictWarp.h"

#include <Eigen/LU>
#include <cmath>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
constexpr double kStep_px = 4.0;
constexpr double kSlopeStep = 1e-3;
constexpr double kGrazing = 1e-2;  ///< cosine to the plane's normal below which a ray misses it

/** A small plane through a point, in the birth camera: n . x = n . p_b. */
struct Plane
{
    Eigen::Vector3d p_b;
    Eigen::Vector3d n_b;
};

/** How pixel offsets around the birth pixel move to pixel offsets now, over a plane. */
class WarpOfPlane
{
   public:
    WarpOfPlane(const Camera& camera, const Appearance& born, const Vector7d& pose)
        : camera_(camera),
          R_cb_(rotationMatrix(pose.tail<4>()).transpose() * rotationMatrix(born.pose.tail<4>())),
          r_cb_(rotationMatrix(pose.tail<4>()).transpose() * (born.pose.head<3>() - pose.head<3>()))
    {
        for (std::size_t i = 0; i < rays_.size(); ++i)
        {
            Eigen::Vector2d offset = Eigen::Vector2d::Zero();
            offset(static_cast<Eigen::Index>(i / 2)) = i % 2 == 0 ? kStep_px : -kStep_px;
            rays_[i] = camera.unproject(born.uv_px + offset);
        }
    }

    [[nodiscard]] std::optional<Eigen::Matrix2d> J_now_born(const Plane& plane) const
    {
        Eigen::Matrix2d J;
        for (std::size_t axis = 0; axis < 2; ++axis)
        {
            const auto plus = seenNow(rays_[2 * axis], plane);
            const auto minus = seenNow(rays_[2 * axis + 1], plane);
            if (!plus || !minus) return std::nullopt;
            J.col(static_cast<Eigen::Index>(axis)) = (*plus - *minus) / (2.0 * kStep_px);
        }
        return J;
    }

   private:
    [[nodiscard]] std::optional<Eigen::Vector2d> seenNow(const std::optional<Eigen::Vector3d>& ray,
                                                         const Plane& plane) const
    {
        if (!ray) return std::nullopt;
        const double along = plane.n_b.dot(*ray);
        if (along <= kGrazing * plane.n_b.norm() * ray->norm()) return std::nullopt;
        return camera_.project(R_cb_ * (*ray * (plane.n_b.dot(plane.p_b) / along)) + r_cb_);
    }

    const Camera& camera_;
    Eigen::Matrix3d R_cb_;
    Eigen::Vector3d r_cb_;
    std::array<std::optional<Eigen::Vector3d>, 4> rays_;
};
}  // namespace

std::optional<PredictedWarp> predictWarp(const Camera& camera, const Appearance& born,
                                         const Vector7d& pose, const Eigen::Vector3d& p_w,
                                         const WarpLimits& limits)
{
    const Eigen::Matrix3d R_bw = rotationMatrix(born.pose.tail<4>()).transpose();
    const Eigen::Vector3d p_b = R_bw * (p_w - born.pose.head<3>());
    const auto ray = camera.unproject(born.uv_px);
    if (!ray) return std::nullopt;
    const Eigen::Vector3d a = ray->normalized();
    const Eigen::Vector3d b = (R_bw * (p_w - pose.head<3>())).normalized();
    if (a.dot(b) < std::cos(limits.maxViewAngle_rad)) return std::nullopt;
    const Eigen::Matrix<double, 3, 2> across = axesAcross(a);
    const Eigen::Vector2d bisector = across.transpose() * b / (1.0 + a.dot(b));

    PredictedWarp warp;
    warp.slope = born.slope.around(bisector);
    const WarpOfPlane over(camera, born, pose);
    const auto at = [&](const Eigen::Vector2d& s) {
        return over.J_now_born({p_b, a + across * s});
    };
    const auto J_now_born = at(warp.slope.mean);
    if (!J_now_born) return std::nullopt;
    const double scale2 = J_now_born->determinant();
    const double limit2 = limits.maxScale * limits.maxScale;
    if (!(scale2 > 1.0 / limit2 && scale2 < limit2)) return std::nullopt;
    warp.M = J_now_born->inverse();
    for (std::size_t k = 0; k < 2; ++k)
    {
        const auto sloped =
            at(warp.slope.mean + kSlopeStep * Eigen::Vector2d::Unit(static_cast<Eigen::Index>(k)));
        if (!sloped) continue;
        // d(J^-1) = -J^-1 dJ J^-1
        warp.J_M_s[k] = -warp.M * ((*sloped - *J_now_born) / kSlopeStep) * warp.M;
    }
    return warp;
}
}  // namespace monoslam
