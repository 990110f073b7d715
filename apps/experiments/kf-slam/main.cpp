// SPDX-License-Identifier: BSD-3-Clause
// Clutter in a rawlog of kf-slam: copies pairs of actions and observations and adds false ones.
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationBearingRange.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "monoslam_mrpt/RawlogObjectStream.h"

namespace monoslam
{
using mrpt::obs::CObservationBearingRange;
using Measurement = CObservationBearingRange::TMeasurement;

namespace
{
/** Where false observations are. */
enum class Clutter
{
    Uniform,    ///< anywhere in the sensor's range and field of view, besides the true ones
    Echo,       ///< near a true one, besides it
    Displaced,  ///< near a true one, instead of it
};

constexpr double kEcho_m = 0.6;
constexpr double kEcho_rad = 0.06;

class Spoiler
{
   public:
    Spoiler(Clutter kind, double mean, unsigned seed) : kind_(kind), mean_(mean), rng_(seed) {}

    /** \return which of the observations are false */
    std::vector<bool> spoil(CObservationBearingRange& observation)
    {
        auto& seen = observation.sensedData;
        const std::size_t truths = seen.size();
        std::vector<bool> isFalse(truths, false);
        const int wanted = std::poisson_distribution<int>(mean_)(rng_);
        for (int k = 0; k < wanted && truths > 0; ++k)
        {
            const auto near = static_cast<std::size_t>(uniform() * static_cast<double>(truths));
            if (kind_ == Clutter::Displaced)
            {
                if (isFalse[near]) continue;
                seen[near] = echoOf(seen[near]);
                isFalse[near] = true;
                continue;
            }
            seen.push_back(kind_ == Clutter::Echo ? echoOf(seen[near]) : anywhere(observation));
            isFalse.push_back(true);
        }
        for (std::size_t i = seen.size(); i > 1; --i)
        {
            const auto j = static_cast<std::size_t>(uniform() * static_cast<double>(i));
            std::swap(seen[i - 1], seen[j]);
            const bool moved = isFalse[j];
            isFalse[j] = isFalse[i - 1];
            isFalse[i - 1] = moved;
        }
        return isFalse;
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

Clutter clutterOf(const std::string& name)
{
    if (name == "uniform") return Clutter::Uniform;
    if (name == "echo") return Clutter::Echo;
    if (name == "displaced") return Clutter::Displaced;
    throw std::invalid_argument("clutter '" + name + "': uniform, echo or displaced");
}

void copyWithClutter(const std::string& from, const std::string& to, Spoiler spoiler)
{
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
}  // namespace
}  // namespace monoslam

int main(int argc, char** argv)
{
    try
    {
        if (argc != 6)
            throw std::invalid_argument(
                "expected: IN.rawlog OUT.rawlog uniform|echo|displaced MEAN_A_FRAME SEED");
        monoslam::copyWithClutter(argv[1], argv[2],
                                  {monoslam::clutterOf(argv[3]), std::stod(argv[4]),
                                   static_cast<unsigned>(std::stoul(argv[5]))});
        return 0;
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "experiment-kf-slam: %s\n", e.what());
        return 1;
    }
}
