// SPDX-License-Identifier: BSD-3-Clause
#include "copyWithClutter.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservationBearingRange.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include "monoslam_mrpt/RawlogObjectStream.h"

namespace monoslam
{
using mrpt::obs::CObservationBearingRange;
using Measurement = CObservationBearingRange::TMeasurement;

namespace
{
constexpr double kEcho_m = 0.6;
constexpr double kEcho_rad = 0.06;

/** Poisson number; std::poisson_distribution differs from one library to the next. */
int drawPoisson(double mean, std::mt19937& rng)
{
    int count = -1;
    for (double product = 1.0; product > std::exp(-mean); ++count)
        product *= (static_cast<double>(rng()) + 0.5) / 4294967296.0;
    return std::max(count, 0);
}

class Spoiler
{
   public:
    Spoiler(Clutter kind, double mean, unsigned seed) : kind_(kind), mean_(mean), rng_(seed) {}

    void spoil(CObservationBearingRange& observation)
    {
        auto& seen = observation.sensedData;
        const std::size_t truths = seen.size();
        std::vector<bool> displaced(truths, false);
        const int wanted = drawPoisson(mean_, rng_);
        for (int k = 0; k < wanted && truths > 0; ++k)
        {
            const auto near = static_cast<std::size_t>(uniform() * static_cast<double>(truths));
            if (kind_ == Clutter::Displaced)
            {
                if (displaced[near]) continue;
                seen[near] = echoOf(seen[near]);
                displaced[near] = true;
                continue;
            }
            seen.push_back(kind_ == Clutter::Echo ? echoOf(seen[near]) : anywhere(observation));
        }
        for (std::size_t i = seen.size(); i > 1; --i)
            std::swap(seen[i - 1],
                      seen[static_cast<std::size_t>(uniform() * static_cast<double>(i))]);
    }

   private:
    double uniform() { return static_cast<double>(rng_()) / 4294967296.0; }
    double within(double half) { return (2.0 * uniform() - 1.0) * half; }

    Measurement echoOf(Measurement m)
    {
        m.range += static_cast<float>(within(kEcho_m));
        m.yaw += static_cast<float>(within(kEcho_rad));
        m.pitch += static_cast<float>(within(kEcho_rad));
        return m;
    }

    Measurement anywhere(const CObservationBearingRange& observation)
    {
        Measurement m = observation.sensedData.front();
        m.range = static_cast<float>((0.1 + 0.9 * uniform()) * observation.maxSensorDistance);
        m.yaw = static_cast<float>(within(0.5 * observation.fieldOfView_yaw));
        m.pitch = static_cast<float>(within(0.5 * observation.fieldOfView_pitch));
        return m;
    }

    Clutter kind_;
    double mean_;
    std::mt19937 rng_;
};
}  // namespace

void copyWithClutter(const std::string& from, const std::string& to, Clutter kind, double mean,
                     unsigned seed)
{
    Spoiler spoiler(kind, mean, seed);
    RawlogObjectStream objects(from);
    mrpt::io::CFileGZOutputStream stream;
    if (!stream.open(to)) throw std::runtime_error(to + ": cannot be written");
    auto archive = mrpt::serialization::archiveFrom(stream);
    while (const auto object = objects.next())
    {
        if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object))
            if (const auto seen = frame->getObservationByClass<CObservationBearingRange>())
                spoiler.spoil(*seen);
        archive << *object;
    }
}
}  // namespace monoslam
