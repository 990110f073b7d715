// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/alignPatch.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>

namespace monoslam
{
namespace
{
using Design = Eigen::Matrix<double, Eigen::Dynamic, 4>;

/** Columns [T_x T_y T 1], one row a pixel. */
Design designOf(const Patch& patch)
{
    Design A(static_cast<Eigen::Index>(patch.side()) * patch.side(), 4);
    Eigen::Index row = 0;
    for (int dy = -patch.half_px; dy <= patch.half_px; ++dy)
        for (int dx = -patch.half_px; dx <= patch.half_px; ++dx, ++row)
        {
            const float gx = 0.5F * (patch.at(dx + 1, dy) - patch.at(dx - 1, dy));
            const float gy = 0.5F * (patch.at(dx, dy + 1) - patch.at(dx, dy - 1));
            A.row(row) << static_cast<double>(gx), static_cast<double>(gy),
                static_cast<double>(patch.at(dx, dy)), 1.0;
        }
    return A;
}

/** The image around uv, one bilinear phase for the whole patch; false outside. */
bool sampleAround(const PreparedImage& image, const Eigen::Vector2d& uv, int half,
                  Eigen::VectorXd& samples)
{
    const cv::Mat& base = image.levels.front();
    const int u = static_cast<int>(std::floor(uv.x()));
    const int v = static_cast<int>(std::floor(uv.y()));
    if (u - half < 0 || v - half < 0 || u + half + 1 >= image.width_px ||
        v + half + 1 >= image.height_px)
        return false;
    const double a = uv.x() - u;
    const double b = uv.y() - v;
    const double w00 = (1 - a) * (1 - b);
    const double w10 = a * (1 - b);
    const double w01 = (1 - a) * b;
    const double w11 = a * b;
    Eigen::Index at = 0;
    for (int y = v - half; y <= v + half; ++y)
    {
        const auto* top = base.ptr<std::uint8_t>(y) + (u - half);
        const auto* low = base.ptr<std::uint8_t>(y + 1) + (u - half);
        for (int x = 0; x <= 2 * half; ++x, ++at)
            samples(at) = w00 * top[x] + w10 * top[x + 1] + w01 * low[x] + w11 * low[x + 1];
    }
    return true;
}

AlignedPatch summarize(const Eigen::Vector2d& uv, const Design& A, const Eigen::Vector4d& fit,
                       const Eigen::VectorXd& samples, const AlignOptions& options)
{
    const double freedom = static_cast<double>(A.rows() - A.cols());
    const double variance = (samples - A * fit).squaredNorm() / freedom;
    const Eigen::Vector4d gainFree(fit(2), fit(2), 1.0, 1.0);
    const Eigen::Matrix4d normal = A.transpose() * A;
    const Eigen::Matrix4d covariance = normal.inverse() * (options.noiseCorrelation * variance);
    const double floor_px = options.sigmaFloor_px;
    AlignedPatch aligned;
    aligned.uv_px = uv;
    aligned.R = covariance.topLeftCorner<2, 2>() / (fit(2) * fit(2)) +
                floor_px * floor_px * Eigen::Matrix2d::Identity();
    aligned.residual = std::sqrt(variance);
    return aligned;
}
}  // namespace

std::optional<AlignedPatch> alignPatch(const PreparedImage& image, const Patch& patch,
                                       const Eigen::Vector2d& start_px, const AlignOptions& options)
{
    const Design A = designOf(patch);
    const Eigen::Matrix4d normal = A.transpose() * A;
    const Eigen::LDLT<Eigen::Matrix4d> ldlt(normal);
    Eigen::VectorXd samples(A.rows());
    Eigen::Vector2d uv = start_px;
    for (int iteration = 0; iteration < options.maxIterations; ++iteration)
    {
        if (!sampleAround(image, uv, patch.half_px, samples)) return std::nullopt;
        const Eigen::Vector4d fit = ldlt.solve(A.transpose() * samples);
        if (!fit.allFinite() || fit(2) < 0.2) return std::nullopt;
        const Eigen::Vector2d delta = fit.head<2>() / fit(2);
        uv -= delta;
        if ((uv - start_px).norm() > options.maxMove_px) return std::nullopt;
        if (delta.norm() > options.convergence_px) continue;
        const AlignedPatch aligned = summarize(uv, A, fit, samples, options);
        if (aligned.residual > options.maxResidual * fit(2) * patch.deviation) return std::nullopt;
        return aligned;
    }
    return std::nullopt;
}
}  // namespace monoslam
