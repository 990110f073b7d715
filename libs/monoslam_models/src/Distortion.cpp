// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_models/Distortion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "radialDistortion.h"

namespace monoslam
{
namespace
{
using radial::OddPolynomial;
using radial::Point;

constexpr double kPi = 3.14159265358979323846;
constexpr double kWidest_rad = 89.0 * kPi / 180.0;

/** x_d = x_n L + tangential part, L = N / D, N = 1 + k1 r^2 + k2 r^4 + k3 r^6, D of k4 k5 k6. */
Point distortBrown(const std::array<double, 8>& k, const Eigen::Vector2d& x_n,
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
Point undistortBrown(const std::array<double, 8>& k, const Eigen::Vector2d& x_d,
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

OddPolynomial polynomial(const DistortionParameters& parameters)
{
    const std::array<double, 8>& k = parameters.k;
    if (parameters.model == DistortionModel::KannalaBrandt) return {{k[0], k[1], k[2], k[3]}};
    const double d2 = k[2] * k[2];  // Tsai: from mm^-2, mm^-4 to pixels by the pixel size
    return {{k[0] * d2, k[1] * d2 * d2, 0.0, 0.0}};
}

/** A map between pixels, with the focal lengths taken out of both sides. */
template <typename PixelMap>
Point inPixels(const PixelMap& map, FocalLengths f, const Eigen::Vector2d& x, Eigen::Matrix2d* J)
{
    const Eigen::Array2d focal(f.fx_px, f.fy_px);
    const Point pixels = map(Eigen::Vector2d(x.array() * focal), J);
    if (!pixels) return {};
    if (J)
    {
        (*J)(0, 1) *= f.fy_px / f.fx_px;
        (*J)(1, 0) *= f.fx_px / f.fy_px;
    }
    return Eigen::Vector2d(pixels->array() / focal);
}

/** Does the map keep its orientation at angle theta, in eight directions? */
bool increasesAt(const DistortionParameters& parameters, double theta)
{
    for (int i = 0; i < 8; ++i)
    {
        const double azimuth = i * kPi / 4;
        const Eigen::Vector2d direction(std::cos(azimuth), std::sin(azimuth));
        const Eigen::Vector2d x_n = std::tan(theta) * direction;
        Eigen::Matrix2d J;
        if (!distort(parameters, {}, x_n, &J) || !(J.determinant() > 0)) return false;
    }
    return true;
}

double firstFold(const DistortionParameters& parameters)
{
    constexpr int kSteps = 890;
    double good = 0, bad = 0;
    for (int i = 1; i <= kSteps && bad == 0; ++i)
    {
        const double theta = kWidest_rad * i / kSteps;
        (increasesAt(parameters, theta) ? good : bad) = theta;
    }
    if (bad == 0) return kWidest_rad;
    for (int i = 0; i < 50; ++i)
    {
        const double middle = 0.5 * (good + bad);
        (increasesAt(parameters, middle) ? good : bad) = middle;
    }
    return good;
}
}  // namespace

std::string name(DistortionModel model)
{
    switch (model)
    {
        case DistortionModel::None: return "none";
        case DistortionModel::Brown: return "brown";
        case DistortionModel::KannalaBrandt: return "kannala_brandt";
        case DistortionModel::Tsai: return "tsai";
        case DistortionModel::Davison: return "davison";
    }
    return "unknown";
}

Point distort(const DistortionParameters& parameters, FocalLengths f, const Eigen::Vector2d& x_n,
              Eigen::Matrix2d* J_xd_xn)
{
    const auto tsai = [&](const Eigen::Vector2d& c, Eigen::Matrix2d* J)
    { return radial::distortTsai(polynomial(parameters), c, J); };
    const auto davison = [&](const Eigen::Vector2d& c, Eigen::Matrix2d* J)
    { return radial::mapDavison(parameters.k[0], c, J); };
    switch (parameters.model)
    {
        case DistortionModel::Brown: return distortBrown(parameters.k, x_n, J_xd_xn);
        case DistortionModel::KannalaBrandt:
            return radial::distortKannalaBrandt(polynomial(parameters), x_n, J_xd_xn);
        case DistortionModel::Tsai: return inPixels(tsai, f, x_n, J_xd_xn);
        case DistortionModel::Davison: return inPixels(davison, f, x_n, J_xd_xn);
        case DistortionModel::None: break;
    }
    if (J_xd_xn) J_xd_xn->setIdentity();
    return x_n;
}

Point undistort(const DistortionParameters& parameters, FocalLengths f, const Eigen::Vector2d& x_d,
                Eigen::Matrix2d* J_xn_xd)
{
    const auto tsai = [&](const Eigen::Vector2d& p, Eigen::Matrix2d* J)
    { return radial::undistortTsai(polynomial(parameters), p, J); };
    const auto davison = [&](const Eigen::Vector2d& p, Eigen::Matrix2d* J)
    { return radial::mapDavison(-parameters.k[0], p, J); };
    switch (parameters.model)
    {
        case DistortionModel::Brown: return undistortBrown(parameters.k, x_d, J_xn_xd);
        case DistortionModel::KannalaBrandt:
            return radial::undistortKannalaBrandt(polynomial(parameters), x_d, J_xn_xd);
        case DistortionModel::Tsai: return inPixels(tsai, f, x_d, J_xn_xd);
        case DistortionModel::Davison: return inPixels(davison, f, x_d, J_xn_xd);
        case DistortionModel::None: break;
    }
    if (J_xn_xd) J_xn_xd->setIdentity();
    return x_d;
}

double maxAngle(const DistortionParameters& parameters, FocalLengths f)
{
    const double focal_px = std::max(f.fx_px, f.fy_px);
    const double widest_px = focal_px * std::tan(kWidest_rad);
    double radius_px = widest_px;
    switch (parameters.model)
    {
        case DistortionModel::None: return kWidest_rad;
        case DistortionModel::Brown:
        case DistortionModel::KannalaBrandt: return firstFold(parameters);
        case DistortionModel::Tsai:
        {
            const OddPolynomial k = polynomial(parameters);
            const double limit_px = radial::largestTsaiRadius_px(k);
            if (std::isfinite(limit_px)) radius_px = limit_px * k.factor(limit_px * limit_px);
            break;
        }
        case DistortionModel::Davison:
            if (parameters.k[0] < 0) radius_px = std::sqrt(-0.5 / parameters.k[0]);
            break;
    }
    return std::atan(std::min(radius_px, widest_px) / focal_px);
}
}  // namespace monoslam
