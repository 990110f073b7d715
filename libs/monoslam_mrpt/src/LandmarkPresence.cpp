// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/LandmarkPresence.h"

#include <algorithm>
#include <cmath>

namespace monoslam
{
namespace
{
constexpr double kMostSightings = 3.0;
}  // namespace

void LandmarkPresence::born()
{
    entries_.push_back({born_++});
}

void LandmarkPresence::seen(std::size_t landmark, double p_detection)
{
    const double sighting = std::log(p_detection / (1.0 - p_detection));
    Entry& entry = entries_.at(landmark);
    entry.newborn = false;
    entry.logOdds = std::min(entry.logOdds + sighting, kMostSightings * sighting);
}

void LandmarkPresence::missed(std::size_t landmark, double p_detection)
{
    entries_.at(landmark).logOdds += std::log1p(-p_detection);
}

std::vector<std::size_t> LandmarkPresence::absent() const
{
    std::vector<std::size_t> absent;
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (entries_[i].logOdds < 0.0) absent.push_back(i);
    return absent;
}

void LandmarkPresence::erase(const std::vector<std::size_t>& landmarks)
{
    for (auto i = landmarks.rbegin(); i != landmarks.rend(); ++i)
        entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(*i));
}
}  // namespace monoslam
