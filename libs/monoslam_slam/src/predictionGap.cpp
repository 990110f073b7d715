// SPDX-License-Identifier: BSD-3-Clause
#include "predictionGap.h"

#include <algorithm>
#include <cmath>

#include "monoslam_association/jointCompatibility.h"

namespace monoslam
{
namespace
{
constexpr double kProbability = 0.95;
}  // namespace

double lineOfSightGrowth_rad(const Eigen::Matrix<double, 6, 6>& before,
                             const Eigen::Matrix<double, 6, 6>& after, double rho)
{
    const Eigen::Matrix<double, 6, 1> grown = (after - before).diagonal();
    const double variance_rad2 = rho * rho * grown.head<3>().mean() + grown.tail<3>().mean();
    return std::sqrt(chi2Limit(2, kProbability) * std::max(variance_rad2, 0.0));
}
}  // namespace monoslam
