// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/timestamps.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace monoslam
{
namespace
{
constexpr Ticks kUnixEpoch = 116444736000000000;  // 1970 in ticks since 1601
constexpr Ticks kTicksPerSecond = 10'000'000;
constexpr double kLargestSeconds = 9e11;

bool allDigits(const std::string& text)
{
    return text.find_first_not_of("0123456789") == std::string::npos;
}

std::optional<Ticks> parseWithExponent(const std::string& text)
{
    char* end = nullptr;
    const long double t_s = std::strtold(text.c_str(), &end);
    if (text.empty() || end != text.c_str() + text.size() || !(std::fabs(t_s) < kLargestSeconds))
        return std::nullopt;
    return static_cast<Ticks>(std::llroundl(t_s * kTicksPerSecond));
}
}  // namespace

mrpt::Clock::time_point clockOf(Ticks ticks)
{
    return mrpt::Clock::time_point{mrpt::Clock::duration{ticks + kUnixEpoch}};
}

Ticks ticksOf(mrpt::Clock::time_point time)
{
    return static_cast<Ticks>(time.time_since_epoch().count()) - kUnixEpoch;
}

double seconds(Ticks ticks)
{
    return static_cast<double>(ticks) / static_cast<double>(kTicksPerSecond);
}

std::optional<Ticks> parseSeconds(const std::string& text)
{
    const auto point = text.find('.');
    const std::string whole = text.substr(0, point);
    std::string fraction = point == std::string::npos ? "" : text.substr(point + 1);
    if (whole.empty() || whole.size() > 11 || !allDigits(whole) || !allDigits(fraction))
        return parseWithExponent(text);
    fraction.resize(std::max<std::size_t>(fraction.size(), 8), '0');
    const Ticks tenth = std::strtoll(fraction.substr(0, 8).c_str(), nullptr, 10);
    return std::strtoll(whole.c_str(), nullptr, 10) * kTicksPerSecond + (tenth + 5) / 10;
}

std::optional<Ticks> parseNanoseconds(const std::string& text)
{
    if (text.empty() || text.size() > 18 + 1 || !allDigits(text)) return std::nullopt;
    const auto ns = std::strtoull(text.c_str(), nullptr, 10);
    return static_cast<Ticks>((ns + 50) / 100);
}
}  // namespace monoslam
