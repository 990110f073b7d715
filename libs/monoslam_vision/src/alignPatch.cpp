// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/alignPatch.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "PatchRegression.h"

namespace monoslam
{
namespace
{
constexpr double kFirstNoise_grey = 3.0;  ///< until the residuals tell
constexpr double kLeastNoise_grey = 0.5;  ///< rounding of the pixels
constexpr double kLeastGain = 0.2;
constexpr double kSlopeSettled = 0.01;  ///< change of it in one step

/** Where the pixels of the patch lie in the image, uv + W d, and the slope that this means. */
struct Placement
{
    Eigen::Vector2d uv_px;
    Eigen::Matrix2d W = Eigen::Matrix2d::Identity();
    Eigen::Vector2d slope;
};

bool isInside(const PreparedImage& image, const Placement& at, int half)
{
    for (const int dx : {-half, half})
        for (const int dy : {-half, half})
        {
            const Eigen::Vector2d p = at.uv_px + at.W * Eigen::Vector2d(dx, dy);
            if (!(p.minCoeff() >= 0.0 && p.x() < image.width_px - 1.0 &&
                  p.y() < image.height_px - 1.0))
                return false;
        }
    return true;
}

/** The image at the pixels of the patch, bilinear. */
void sample(const PreparedImage& image, const Placement& at, int half, PatchSamples& samples)
{
    const cv::Mat& base = image.levels.front();
    const Eigen::Matrix2f W = at.W.cast<float>();
    const Eigen::Vector2d corner = at.uv_px + at.W * Eigen::Vector2d(-half, -half);
    const auto left = static_cast<float>(corner.x());
    const auto top = static_cast<float>(corner.y());
    Eigen::Index row = 0;
    for (int y = 0; y <= 2 * half; ++y)
        for (int x = 0; x <= 2 * half; ++x, ++row)
        {
            const float pu =
                left + W(0, 0) * static_cast<float>(x) + W(0, 1) * static_cast<float>(y);
            const float pv =
                top + W(1, 0) * static_cast<float>(x) + W(1, 1) * static_cast<float>(y);
            const int u = static_cast<int>(pu);
            const int v = static_cast<int>(pv);
            const float a = pu - static_cast<float>(u);
            const float b = pv - static_cast<float>(v);
            const auto* upper = base.ptr<std::uint8_t>(v) + u;
            const auto* lower = upper + base.step[0];
            const auto u0 = static_cast<float>(upper[0]);
            const auto l0 = static_cast<float>(lower[0]);
            const float above = u0 + a * (static_cast<float>(upper[1]) - u0);
            const float below = l0 + a * (static_cast<float>(lower[1]) - l0);
            samples(row) = above + b * (below - above);
        }
}

/** One inverse-compositional step. */
Placement stepped(const Placement& at, const Patch& patch, const PatchRegression::Unknowns& x)
{
    const PatchRegression::Unknowns d = x / x(PatchRegression::kGain);
    const Eigen::Matrix2d E = patch.stretch[0] * d(PatchRegression::kSlope) +
                              patch.stretch[1] * d(PatchRegression::kSlope + 1);
    Placement next;
    next.W = at.W * (Eigen::Matrix2d::Identity() + E).inverse();
    next.uv_px = at.uv_px - next.W * d.head<2>();
    next.slope = at.slope + d.segment<2>(PatchRegression::kSlope);
    return next;
}
}  // namespace

std::optional<AlignedPatch> alignPatch(const PreparedImage& image, const Patch& patch,
                                       const Eigen::Vector2d& start_px, const AlignOptions& options)
{
    PatchRegression regression(patch);
    PatchSamples samples(static_cast<Eigen::Index>(patch.side()) * patch.side());
    Placement at{start_px, Eigen::Matrix2d::Identity(), patch.slope.mean};
    double noise = options.noiseCorrelation * kFirstNoise_grey * kFirstNoise_grey;
    double gain = 1.0;
    for (int iteration = 0; iteration < options.maxIterations; ++iteration)
    {
        if (!isInside(image, at, patch.half_px)) return std::nullopt;
        sample(image, at, patch.half_px, samples);
        const PatchRegression::Unknowns x = regression.fit(samples, at.slope, gain, noise);
        gain = x(PatchRegression::kGain);
        if (!x.allFinite() || gain < kLeastGain) return std::nullopt;
        const double variance =
            std::max(regression.variance(samples, x), kLeastNoise_grey * kLeastNoise_grey);
        noise = options.noiseCorrelation * variance / (gain * gain);
        const Placement next = stepped(at, patch, x);
        const double moved_px = (next.uv_px - at.uv_px).norm();
        const double tilted = (next.slope - at.slope).norm();
        at = next;
        if (!((at.uv_px - start_px).norm() <= options.maxMove_px)) return std::nullopt;
        if (moved_px > options.convergence_px || tilted > kSlopeSettled) continue;
        if (std::sqrt(variance) > options.maxResidual * gain * patch.deviation) return std::nullopt;
        AlignedPatch aligned;
        aligned.uv_px = at.uv_px;
        aligned.R = noise * regression.shiftCovariance() +
                    options.sigmaFloor_px * options.sigmaFloor_px * Eigen::Matrix2d::Identity();
        aligned.residual = std::sqrt(variance);
        aligned.slope.information = regression.slopeInformation() / noise;
        // Posterior = pixels + prior, solved for what the pixels say.
        const Eigen::Vector2d eta = aligned.slope.information * at.slope +
                                    patch.slope.information * (at.slope - patch.slope.mean);
        aligned.slope.mean =
            (aligned.slope.information + 1e-9 * Eigen::Matrix2d::Identity()).inverse() * eta;
        return aligned;
    }
    return std::nullopt;
}
}  // namespace monoslam
