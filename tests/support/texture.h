// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <opencv2/core.hpp>
#include <random>
#include <vector>

#include "randomValues.h"

namespace monoslam
{
/** A picture without pixels: a sum of waves of 6 to 30 px, so that any shift of it is exact. */
class Texture
{
   public:
    explicit Texture(unsigned seed, double contrast_grey = 30.0)
    {
        std::mt19937 rng(seed);
        constexpr int kWaves = 24;
        for (int i = 0; i < kWaves; ++i)
        {
            const double length_px = uniform(rng, 6.0, 30.0);
            const double angle = uniform(rng, 0.0, 2.0 * M_PI);
            waves_.push_back({2.0 * M_PI / length_px * std::cos(angle),
                              2.0 * M_PI / length_px * std::sin(angle),
                              uniform(rng, 0.0, 2.0 * M_PI)});
        }
        amplitude_ = contrast_grey * std::sqrt(2.0 / kWaves);
    }

    [[nodiscard]] double at(double x, double y) const
    {
        double sum = 0.0;
        for (const Wave& wave : waves_) sum += std::cos(wave.kx * x + wave.ky * y + wave.phase);
        return 128.0 + amplitude_ * sum;
    }

   private:
    struct Wave
    {
        double kx;
        double ky;
        double phase;
    };
    std::vector<Wave> waves_;
    double amplitude_ = 1.0;
};

/** 8-bit image of grey(u, v) with noise. */
inline cv::Mat renderImage(int width_px, int height_px,
                           const std::function<double(double u, double v)>& grey,
                           double noise_grey = 0.0, unsigned seed = 1)
{
    std::mt19937 rng(seed);
    std::normal_distribution<double> normal(0.0, 1.0);
    cv::Mat image(height_px, width_px, CV_8UC1);
    for (int v = 0; v < height_px; ++v)
        for (int u = 0; u < width_px; ++u)
            image.at<std::uint8_t>(v, u) =
                cv::saturate_cast<std::uint8_t>(grey(u, v) + noise_grey * normal(rng));
    return image;
}
}  // namespace monoslam
