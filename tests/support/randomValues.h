// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <random>

namespace monoslam
{
inline double uniform(std::mt19937& rng, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(rng);
}

/** Independent uniform numbers in [-scale, scale]. */
template <int N>
Eigen::Matrix<double, N, 1> uniformVector(std::mt19937& rng, double scale)
{
    Eigen::Matrix<double, N, 1> numbers;
    for (double& number : numbers) number = uniform(rng, -scale, scale);
    return numbers;
}

/** Independent normal numbers of standard deviation sigma. */
template <int N>
Eigen::Matrix<double, N, 1> normalVector(std::mt19937& rng, double sigma)
{
    std::normal_distribution<double> normal(0.0, sigma);
    Eigen::Matrix<double, N, 1> numbers;
    for (double& number : numbers) number = normal(rng);
    return numbers;
}

/** Uniform over all rotations, both signs. */
inline Eigen::Vector4d randomQuaternion(std::mt19937& rng)
{
    return normalVector<4>(rng, 1.0).normalized();
}
}  // namespace monoslam
