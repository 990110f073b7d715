// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_mrpt/CObservationPixelFeatures.h"

#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <cstdio>
#include <ostream>

namespace monoslam
{
using mrpt::serialization::CArchive;

IMPLEMENTS_SERIALIZABLE(CObservationPixelFeatures, CObservation, monoslam)

namespace
{
void write(CArchive& out, const PixelFeature& feature)
{
    out << feature.id << feature.truth << feature.z.x() << feature.z.y() << feature.R(0, 0)
        << feature.R(0, 1) << feature.R(1, 1)
        << static_cast<std::uint32_t>(feature.resembles.size());
    for (const Resemblance& like : feature.resembles) out << like.landmark << like.score;
}

PixelFeature readFeature(CArchive& in)
{
    PixelFeature feature;
    std::uint32_t count = 0;
    in >> feature.id >> feature.truth >> feature.z.x() >> feature.z.y() >> feature.R(0, 0) >>
        feature.R(0, 1) >> feature.R(1, 1) >> count;
    feature.R(1, 0) = feature.R(0, 1);
    for (; count > 0; --count)  // not resized at once: a damaged count must not ask for memory
    {
        Resemblance like;
        in >> like.landmark >> like.score;
        feature.resembles.push_back(like);
    }
    return feature;
}
}  // namespace

std::uint8_t CObservationPixelFeatures::serializeGetVersion() const
{
    return 0;
}

void CObservationPixelFeatures::serializeTo(CArchive& out) const
{
    out << timestamp << sensorLabel << cameraPose << cameraParams
        << static_cast<std::uint32_t>(features.size());
    for (const PixelFeature& feature : features) write(out, feature);
}

void CObservationPixelFeatures::serializeFrom(CArchive& in, std::uint8_t version)
{
    if (version != 0) MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
    std::uint32_t count = 0;
    in >> timestamp >> sensorLabel >> cameraPose >> cameraParams >> count;
    features.clear();
    for (; count > 0; --count) features.push_back(readFeature(in));
}

void CObservationPixelFeatures::getDescriptionAsText(std::ostream& text) const
{
    CObservation::getDescriptionAsText(text);
    text << "Camera pose on the vehicle: " << cameraPose << "\n"
         << cameraParams.dumpAsText() << "\n"
         << features.size() << " features: id, u, v [px], truth (-1: no landmark, -2: unknown), "
         << "landmark:score of each that it looks like\n";
    char line[96];
    for (const PixelFeature& feature : features)
    {
        std::snprintf(line, sizeof line, "%6lld %9.3f %9.3f %6lld ",
                      static_cast<long long>(feature.id), feature.z.x(), feature.z.y(),
                      static_cast<long long>(feature.truth));
        text << line;
        for (const Resemblance& like : feature.resembles)
        {
            std::snprintf(line, sizeof line, " %lld:%.3f", static_cast<long long>(like.landmark),
                          like.score);
            text << line;
        }
        text << "\n";
    }
}

std::string CObservationPixelFeatures::exportTxtHeader() const
{
    return "COUNT {ID U V SIGMA_U SIGMA_V TRUTH}*COUNT";
}

std::string CObservationPixelFeatures::exportTxtDataRow() const
{
    std::string row = std::to_string(features.size());
    char cells[160];
    for (const PixelFeature& feature : features)
    {
        std::snprintf(cells, sizeof cells, " %lld %.4f %.4f %.4f %.4f %lld",
                      static_cast<long long>(feature.id), feature.z.x(), feature.z.y(),
                      std::sqrt(feature.R(0, 0)), std::sqrt(feature.R(1, 1)),
                      static_cast<long long>(feature.truth));
        row += cells;
    }
    return row;
}
}  // namespace monoslam
