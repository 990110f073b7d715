// SPDX-License-Identifier: BSD-3-Clause
#include "edgeModel.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "srgbCurve.h"

namespace monoslam
{
namespace
{
constexpr int kMostSteps = 20;
constexpr int kSideSize = 6;
constexpr int kSize = 4 * kSideSize + 1;
using Parameters = Eigen::Matrix<double, kSize, 1>;
using Normal = Eigen::Matrix<double, kSize, kSize>;
using SideGradient = Eigen::Matrix<double, kSideSize, 1>;

/** light = (1 - t) v + t srgb(v); v may leave [0, 1] a little, where it goes on straight. */
struct Response
{
    double t;
    [[nodiscard]] Light at(double v, const Light& curve) const
    {
        return {(1.0 - t) * v + t * curve.value, 1.0 - t + t * curve.slope};
    }
    [[nodiscard]] double grey(double wanted, double guess) const
    {
        double v = guess;
        for (int i = 0; i < 8; ++i)
        {
            const Light light = at(v, srgb(v));
            const double step = (wanted - light.value) / light.slope;
            v += std::clamp(step, -0.3, 0.3);
            if (std::abs(step) < 1e-7) break;
        }
        return v;
    }
};

struct Modelled
{
    double grey;            ///< 0 .. 1
    SideGradient gradient;  ///< over the side's parameters
    double dt;              ///< over the response
};

Modelled modelled(const EdgePixel& pixel, const SideFit& side, double t)
{
    const Response response{t};
    const double u =
        (pixel.d_px - pixel.stretch * (side.offset_px + side.tilt_px * pixel.s)) / side.blur_px;
    const double Phi = 0.5 * std::erfc(-u * M_SQRT1_2);
    const double density = std::exp(-0.5 * u * u) / std::sqrt(2.0 * M_PI) / side.blur_px;
    const double outside = side.outside + side.shading * pixel.s;
    const Light inCurve = srgb(side.inside);
    const Light outCurve = srgb(outside);
    const Light in = response.at(side.inside, inCurve);
    const Light out = response.at(outside, outCurve);
    Modelled m;
    // The pixel itself is the best first guess of a model that fits it.
    m.grey = response.grey(in.value + (out.value - in.value) * Phi, pixel.grey / 255.0);
    const Light curve = srgb(m.grey);
    const double J_v_light = 1.0 / response.at(m.grey, curve).slope;
    const double J_light_d = (out.value - in.value) * density;
    m.gradient << -J_light_d * pixel.stretch, -J_light_d * pixel.stretch * pixel.s,
        in.slope * (1.0 - Phi), out.slope * Phi, out.slope * Phi * pixel.s, -J_light_d * u;
    m.gradient *= J_v_light;
    m.dt = J_v_light * ((1.0 - Phi) * (inCurve.value - side.inside) +
                        Phi * (outCurve.value - outside) - (curve.value - m.grey));
    return m;
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::optional<SideFit> firstGuess(const std::vector<EdgePixel>& pixels)
{
    std::vector<double> inside;
    std::vector<double> outside;
    for (const auto& pixel : pixels)
    {
        if (pixel.d_px < -2.0) inside.push_back(pixel.grey / 255.0);
        if (pixel.d_px > 2.0) outside.push_back(pixel.grey / 255.0);
    }
    if (inside.size() < 8 || outside.size() < 8) return std::nullopt;
    SideFit side;
    side.inside = median(std::move(inside));
    side.outside = median(std::move(outside));
    return side;
}

/** A^-1 b with the response kept in [0, 1]: at the bound the others move as if it were known. */
Parameters solved(Normal A, Parameters b, double response)
{
    const Parameters free = A.ldlt().solve(b);
    const double wanted = response + free(kSize - 1);
    if (wanted >= 0.0 && wanted <= 1.0) return free;
    const double move = std::clamp(wanted, 0.0, 1.0) - response;
    b -= move * A.col(kSize - 1);
    b(kSize - 1) = move;
    A.col(kSize - 1).setZero();
    A.row(kSize - 1).setZero();
    A(kSize - 1, kSize - 1) = 1.0;
    return A.ldlt().solve(b);
}

/** One Gauss-Newton step; Huber weights at 2.5 sigma. */
Parameters step(const std::array<std::vector<EdgePixel>, 4>& sides, EdgeFit& fit)
{
    Normal A = Normal::Zero();
    Parameters b = Parameters::Zero();
    std::vector<double> residuals;
    const double sigma = std::max(fit.noise_grey, 0.5) / 255.0;
    for (int k = 0; k < 4; ++k)
        for (const auto& pixel : sides[k])
        {
            const Modelled m = modelled(pixel, fit.sides[k], fit.response);
            const double r = pixel.grey / 255.0 - m.grey;
            const double weight = std::min(1.0, 2.5 * sigma / std::max(std::abs(r), 1e-9));
            const int at = kSideSize * k;
            A.block<kSideSize, kSideSize>(at, at) += weight * m.gradient * m.gradient.transpose();
            A.block<kSideSize, 1>(at, kSize - 1) += weight * m.dt * m.gradient;
            A(kSize - 1, kSize - 1) += weight * m.dt * m.dt;
            b.segment<kSideSize>(at) += weight * r * m.gradient;
            b(kSize - 1) += weight * r * m.dt;
            residuals.push_back(std::abs(r));
        }
    A(kSize - 1, kSize - 1) += sigma * sigma / 0.25;  // prior: response 0.5 +- 0.5
    b(kSize - 1) += sigma * sigma / 0.25 * (0.5 - fit.response);
    A.bottomRows<1>() = A.rightCols<1>().transpose();
    A.diagonal().array() *= 1.0 + 1e-6;
    fit.noise_grey = 255.0 * 1.4826 * median(std::move(residuals));
    return solved(A, b, fit.response);
}

void apply(const Parameters& change, EdgeFit& fit)
{
    for (int k = 0; k < 4; ++k)
    {
        const SideGradient d = change.segment<kSideSize>(kSideSize * k);
        SideFit& side = fit.sides[k];
        side.offset_px += std::clamp(d(0), -1.0, 1.0);
        side.tilt_px += std::clamp(d(1), -1.0, 1.0);
        side.inside = std::clamp(side.inside + d(2), -0.2, 1.2);
        side.outside = std::clamp(side.outside + d(3), -0.2, 1.2);
        side.shading = std::clamp(side.shading + d(4), -0.2, 0.2);
        side.blur_px = std::clamp(side.blur_px + std::clamp(d(5), -0.3, 0.3), 0.3, 4.0);
    }
    fit.response = std::clamp(fit.response + change(kSize - 1), 0.0, 1.0);
}
}  // namespace

std::optional<EdgeFit> fitEdges(const std::array<std::vector<EdgePixel>, 4>& sides,
                                const EdgeFit* before, double tolerance)
{
    EdgeFit fit;
    fit.noise_grey = 10.0;
    if (before) fit = *before;
    for (int k = 0; k < 4; ++k)
    {
        const auto side = firstGuess(sides[k]);
        if (!side) return std::nullopt;
        if (!before) fit.sides[k] = *side;
        fit.sides[k].offset_px = fit.sides[k].tilt_px = 0.0;
    }
    // Response, grey levels and blur explain nearly the same: along that valley full steps may go from
    // side to side for ever, so a step that turns back is halved.
    double share = 1.0;
    Parameters last = Parameters::Zero();
    for (int iteration = 0; iteration < kMostSteps; ++iteration)
    {
        const Parameters change = step(sides, fit);
        if (!change.allFinite()) return std::nullopt;
        share = change.dot(last) < 0.0 ? 0.5 * share : std::min(1.0, 2.0 * share);
        last = change;
        apply(share * change, fit);
        fit.steps = iteration + 1;
        if (iteration > 1 && change.cwiseAbs().maxCoeff() < tolerance) break;
    }
    return fit;
}
}  // namespace monoslam
