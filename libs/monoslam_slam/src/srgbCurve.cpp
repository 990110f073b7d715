// SPDX-License-Identifier: BSD-3-Clause
#include "srgbCurve.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace monoslam
{
namespace
{
/** The curve between 1/16 and 17/16 by cubics that meet it in value and slope. */
class SrgbTable
{
   public:
    SrgbTable()
    {
        for (std::size_t i = 0; i < nodes_.size(); ++i) nodes_[i] = srgbByPower(kFrom + i * kStep);
    }

    [[nodiscard]] Light at(double v) const
    {
        const double place = (v - kFrom) / kStep;
        if (!(place >= 0.0 && place < kIntervals)) return srgbByPower(v);
        const auto i = static_cast<std::size_t>(place);
        const double t = place - static_cast<double>(i);
        const Light& a = nodes_[i];
        const Light& b = nodes_[i + 1];
        const double rise = b.value - a.value;
        const double bend_a = a.slope * kStep - rise;
        const double bend_b = rise - b.slope * kStep;
        const double bend = (1.0 - t) * bend_a + t * bend_b;
        return {a.value + t * rise + t * (1.0 - t) * bend,
                (rise + (1.0 - 2.0 * t) * bend + t * (1.0 - t) * (bend_b - bend_a)) / kStep};
    }

   private:
    static constexpr int kIntervals = 512;
    static constexpr double kFrom = 1.0 / 16;
    static constexpr double kStep = 1.0 / kIntervals;
    std::array<Light, kIntervals + 1> nodes_{};
};
}  // namespace

Light srgbByPower(double v)
{
    if (v <= 0.04045) return {v / 12.92, 1.0 / 12.92};
    const double base = (v + 0.055) / 1.055;
    const double power = std::pow(base, 1.4);
    return {base * power, 2.4 / 1.055 * power};
}

Light srgb(double v)
{
    static const SrgbTable table;
    return table.at(v);
}
}  // namespace monoslam
