// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_models/Distortion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "distortionModels.h"

namespace monoslam
{
namespace
{
using namespace distortion;

constexpr double kPi = 3.14159265358979323846;
constexpr double kWidest_rad = 89.0 * kPi / 180.0;

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
        case DistortionModel::None:
            return "none";
        case DistortionModel::Brown:
            return "brown";
        case DistortionModel::KannalaBrandt:
            return "kannala_brandt";
        case DistortionModel::Tsai:
            return "tsai";
        case DistortionModel::Davison:
            return "davison";
    }
    return "unknown";
}

Point distort(const DistortionParameters& parameters, FocalLengths f, const Eigen::Vector2d& x_n,
              Eigen::Matrix2d* J_xd_xn)
{
    const auto tsai = [&](const Eigen::Vector2d& c, Eigen::Matrix2d* J)
    { return distortTsai(polynomial(parameters), c, J); };
    const auto davison = [&](const Eigen::Vector2d& c, Eigen::Matrix2d* J)
    { return mapDavison(parameters.k[0], c, J); };
    switch (parameters.model)
    {
        case DistortionModel::Brown:
            return distortBrown(parameters.k, x_n, J_xd_xn);
        case DistortionModel::KannalaBrandt:
            return distortKannalaBrandt(polynomial(parameters), x_n, J_xd_xn);
        case DistortionModel::Tsai:
            return inPixels(tsai, f, x_n, J_xd_xn);
        case DistortionModel::Davison:
            return inPixels(davison, f, x_n, J_xd_xn);
        case DistortionModel::None:
            break;
    }
    if (J_xd_xn) J_xd_xn->setIdentity();
    return x_n;
}

Point undistort(const DistortionParameters& parameters, FocalLengths f, const Eigen::Vector2d& x_d,
                Eigen::Matrix2d* J_xn_xd)
{
    const auto tsai = [&](const Eigen::Vector2d& p, Eigen::Matrix2d* J)
    { return undistortTsai(polynomial(parameters), p, J); };
    const auto davison = [&](const Eigen::Vector2d& p, Eigen::Matrix2d* J)
    { return mapDavison(-parameters.k[0], p, J); };
    switch (parameters.model)
    {
        case DistortionModel::Brown:
            return undistortBrown(parameters.k, x_d, J_xn_xd);
        case DistortionModel::KannalaBrandt:
            return undistortKannalaBrandt(polynomial(parameters), x_d, J_xn_xd);
        case DistortionModel::Tsai:
            return inPixels(tsai, f, x_d, J_xn_xd);
        case DistortionModel::Davison:
            return inPixels(davison, f, x_d, J_xn_xd);
        case DistortionModel::None:
            break;
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
        case DistortionModel::None:
            return kWidest_rad;
        case DistortionModel::Brown:
        case DistortionModel::KannalaBrandt:
            return firstFold(parameters);
        case DistortionModel::Tsai:
        {
            const OddPolynomial k = polynomial(parameters);
            const double limit_px = largestTsaiRadius_px(k);
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
