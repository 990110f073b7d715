// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

/** The distortion models one by one, private to Distortion.cpp.
 *
 * Brown and Kannala-Brandt work in normalised coordinates; Tsai and Davison in pixels relative to
 * the principal point, c before and p after the distortion. */
namespace monoslam::distortion
{
using Point = std::optional<Eigen::Vector2d>;

/** s (1 + a0 s^2 + a1 s^4 + a2 s^6 + a3 s^8) and its derivative. */
struct OddPolynomial
{
    std::array<double, 4> a{};

    [[nodiscard]] double factor(double s2) const
    {
        return 1 + s2 * (a[0] + s2 * (a[1] + s2 * (a[2] + s2 * a[3])));
    }
    [[nodiscard]] double derivative(double s2) const
    {
        return 1 + s2 * (3 * a[0] + s2 * (5 * a[1] + s2 * (7 * a[2] + s2 * 9 * a[3])));
    }
    /** The s >= 0 of the first increasing branch with value t: Newton, kept inside a bracket. */
    [[nodiscard]] std::optional<double> invert(double t) const
    {
        double low = 0, high = std::numeric_limits<double>::infinity(), s = t;
        for (int i = 0; i < 100; ++i)
        {
            const double error = s * factor(s * s) - t;
            const double slope = derivative(s * s);
            if (slope > 0 && std::abs(error) <= 1e-15 * (s + t)) break;
            (error > 0 || slope <= 0 ? high : low) = s;
            double next = s - error / slope;
            const bool isInside = slope > 0 && next >= low && next <= high;
            if (!isInside) next = std::isinf(high) ? 2 * s : 0.5 * (low + high);
            if (std::abs(next - s) <= 1e-15 * s) break;  // at the solution, or at the fold
            s = next;
        }
        const bool isSolved = std::abs(s * factor(s * s) - t) <= 1e-12 * (s + t);
        return isSolved && derivative(s * s) > 0 ? std::optional<double>(s) : std::nullopt;
    }
};

/** x_d = x_n L + tangential part, L = N / D, N = 1 + k1 r^2 + k2 r^4 + k3 r^6, D of k4 k5 k6. */
inline Point distortBrown(const std::array<double, 8>& k, const Eigen::Vector2d& x_n,
                          Eigen::Matrix2d* J_xd_xn)
{
    const double x = x_n.x(), y = x_n.y(), p1 = k[2], p2 = k[3];
    const double r2 = x_n.squaredNorm();
    const double N = 1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
    const double D = 1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7]));
    if (D <= 0) return {};
    const double L = N / D;
    if (J_xd_xn)
    {
        const double dN = k[0] + r2 * (2 * k[1] + 3 * r2 * k[4]);
        const double dD = k[5] + r2 * (2 * k[6] + 3 * r2 * k[7]);
        const double E = 2 * (dN - L * dD) / D;  // dL/dx = E x, dL/dy = E y
        const double J_xy = x * y * E + 2 * p1 * x + 2 * p2 * y;
        *J_xd_xn << L + x * x * E + 2 * p1 * y + 6 * p2 * x, J_xy,  //
            J_xy, L + y * y * E + 6 * p1 * y + 2 * p2 * x;
    }
    return Eigen::Vector2d(x * L + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
                           y * L + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y);
}

/** Newton from x_d; a step past the fold, where det J <= 0, is halved until it stays before it. */
inline Point undistortBrown(const std::array<double, 8>& k, const Eigen::Vector2d& x_d,
                            Eigen::Matrix2d* J_xn_xd)
{
    Eigen::Vector2d x = x_d, lastValid = Eigen::Vector2d::Zero();
    Eigen::Matrix2d J_xd_xn;
    for (int i = 0; i < 50; ++i)
    {
        const Point distorted = distortBrown(k, x, &J_xd_xn);
        if (!distorted || !(J_xd_xn.determinant() > 0))
        {
            x = 0.5 * (x + lastValid);
            continue;
        }
        lastValid = x;
        const Eigen::Matrix2d J_inverse = J_xd_xn.inverse();
        const Eigen::Vector2d step = J_inverse * (x_d - *distorted);
        x += step;
        if (step.norm() > 1e-12 * (1 + x.norm())) continue;
        if (J_xn_xd) *J_xn_xd = J_inverse;
        return x;
    }
    return {};
}

/** theta_d = theta (1 + k1 theta^2 + ...), x_d = x_n theta_d / r with r = tan theta = |x_n|. */
inline Point distortKannalaBrandt(const OddPolynomial& k, const Eigen::Vector2d& x_n,
                                  Eigen::Matrix2d* J_xd_xn)
{
    const double r2 = x_n.squaredNorm();
    const double r = std::sqrt(r2);
    const bool isCentre = r < 1e-4;  // s = theta_d / r is 0 / 0 on the axis: its series there
    const double theta = std::atan(r);
    const double s = isCentre ? 1 + (k.a[0] - 1.0 / 3) * r2 : theta * k.factor(theta * theta) / r;
    const double ds_r =
        isCentre ? 2 * (k.a[0] - 1.0 / 3) : (k.derivative(theta * theta) / (1 + r2) - s) / r2;
    if (J_xd_xn) *J_xd_xn = s * Eigen::Matrix2d::Identity() + ds_r * x_n * x_n.transpose();
    return Eigen::Vector2d(s * x_n);
}

inline Point undistortKannalaBrandt(const OddPolynomial& k, const Eigen::Vector2d& x_d,
                                    Eigen::Matrix2d* J_xn_xd)
{
    const double theta_d = x_d.norm();
    const std::optional<double> theta = k.invert(theta_d);
    if (!theta || *theta >= std::acos(0.0)) return {};
    const double scale = theta_d > 0 ? std::tan(*theta) / theta_d : 1.0;
    const Eigen::Vector2d x_n = scale * x_d;
    Eigen::Matrix2d J_xd_xn;
    (void)distortKannalaBrandt(k, x_n, &J_xd_xn);
    if (J_xn_xd) *J_xn_xd = J_xd_xn.inverse();
    return x_n;
}

/** Largest distorted radius at which c(p) of Tsai still increases: 1 + 3 a u + 5 b u^2 = 0. */
inline double largestTsaiRadius_px(const OddPolynomial& k)
{
    const double a = 3 * k.a[0], b = 5 * k.a[1];
    const double discriminant = a * a - 4 * b;
    if (discriminant < 0) return std::numeric_limits<double>::infinity();
    // the smaller positive root, as 2 / (-a + ...), which does not cancel and covers b = 0
    const double denominator = -a + std::sqrt(discriminant);
    return denominator > 0 ? std::sqrt(2 / denominator) : std::numeric_limits<double>::infinity();
}

/** c = p (1 + k1 |p|^2 + k2 |p|^4). */
inline Point undistortTsai(const OddPolynomial& k, const Eigen::Vector2d& p, Eigen::Matrix2d* J_c_p)
{
    const double r2 = p.squaredNorm();
    const double limit = largestTsaiRadius_px(k);
    if (r2 >= limit * limit) return {};
    if (J_c_p)
        *J_c_p = k.factor(r2) * Eigen::Matrix2d::Identity() +
                 (2 * k.a[0] + 4 * k.a[1] * r2) * p * p.transpose();
    return Eigen::Vector2d(k.factor(r2) * p);
}

inline Point distortTsai(const OddPolynomial& k, const Eigen::Vector2d& c, Eigen::Matrix2d* J_p_c)
{
    const double radius = c.norm();
    const std::optional<double> distorted = k.invert(radius);
    if (!distorted) return {};
    const double scale = radius > 0 ? *distorted / radius : 1.0;
    const Eigen::Vector2d p = scale * c;
    Eigen::Matrix2d J_c_p;
    if (!undistortTsai(k, p, &J_c_p)) return {};
    if (J_p_c) *J_p_c = J_c_p.inverse();
    return p;
}

/** p = c / sqrt(1 + 2 K1 |c|^2); its inverse is the same with -K1. */
inline Point mapDavison(double K1, const Eigen::Vector2d& c, Eigen::Matrix2d* J_p_c)
{
    const double f = 1 + 2 * K1 * c.squaredNorm();
    if (f <= 0) return {};
    const double root = std::sqrt(f);
    if (J_p_c)
        *J_p_c = Eigen::Matrix2d::Identity() / root - 2 * K1 / (f * root) * c * c.transpose();
    return Eigen::Vector2d(c / root);
}
}  // namespace monoslam::distortion
