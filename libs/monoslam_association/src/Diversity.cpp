// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_association/Diversity.h"

#include <algorithm>
#include <cmath>

#include "monoslam_models/quaternion.h"

namespace monoslam
{
namespace
{
double angleBetween_rad(const Eigen::Vector4d& a, const Eigen::Vector4d& b)
{
    const Eigen::Vector4d turn = quaternionProduct(quaternionConjugate(a), b);
    return 2.0 * std::atan2(turn.tail<3>().norm(), std::abs(turn(0)));
}

double effectiveCount(const Mixture& mixture)
{
    double largest = mixture.front().logWeight, sum = 0.0, squares = 0.0;
    for (const auto& weighted : mixture) largest = std::max(largest, weighted.logWeight);
    for (const auto& weighted : mixture)
    {
        const double weight = std::exp(weighted.logWeight - largest);
        sum += weight;
        squares += weight * weight;
    }
    return sum * sum / squares;
}
}  // namespace

Diversity diversityOf(const Mixture& mixture)
{
    Diversity d;
    d.beliefs = static_cast<long>(mixture.size());
    if (mixture.empty()) return d;
    d.effective = effectiveCount(mixture);
    for (const auto& a : mixture)
    {
        for (const auto& b : mixture)
        {
            const Vector7d p = a.belief.pose(), q = b.belief.pose();
            d.distance = std::max(d.distance, (p.head<3>() - q.head<3>()).norm());
            d.angle_rad = std::max(d.angle_rad, angleBetween_rad(p.tail<4>(), q.tail<4>()));
        }
        for (const long age : a.separation)
            d.ancestorAge_frames = std::max(d.ancestorAge_frames, age);
    }
    return d;
}
}  // namespace monoslam
