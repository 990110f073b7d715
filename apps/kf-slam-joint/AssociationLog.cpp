// SPDX-License-Identifier: BSD-3-Clause
#include "AssociationLog.h"

#include <mrpt/math/CMatrixDynamic.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace monoslam
{
namespace
{
constexpr const char* kAssociationHeader =
    "%           TIMESTAMP                INDEX_IN_OBS    ID    RANGE(m)    YAW(rad)   PITCH(rad) "
    "\n"
    "%-------------------------------------------------------"
    "-------------------------------------\n";
constexpr const char* kPerformanceHeader =
    "%           TIMESTAMP                INDEX_IN_OBS    TruePos FalsePos TrueNeg FalseNeg  "
    "NoGroundTruthSoIDontKnow \n"
    "%--------------------------------------------------------------"
    "--------------------------------------------------\n";

template <typename Map>
int valueOr(const Map& map, std::size_t key, int fallback)
{
    const auto entry = map.find(key);
    return entry == map.end() ? fallback : static_cast<int>(entry->second);
}
}  // namespace

AssociationLog::AssociationLog(const std::string& folder, bool withAssociations,
                               const std::string& truth)
    : performance_(folder + "/data_association_performance.log")
{
    performance_.write(kPerformanceHeader);
    if (withAssociations)
    {
        associations_ = std::make_unique<OutputFile>(folder + "/data_association.log");
        associations_->write(kAssociationHeader);
    }
    if (truth.empty()) return;
    mrpt::math::CMatrixDouble table;
    table.loadFromTextFile(truth);
    if (table.cols() < 3) throw std::runtime_error(truth + ": has fewer than three columns");
    for (int row = 0; row < table.rows(); ++row)
        truth_[table(row, 0)][static_cast<std::size_t>(table(row, 1))] =
            static_cast<int>(table(row, 2));
}

AssociationLog::Verdict AssociationLog::judge(double t_s, std::size_t index, const Filter& filter)
{
    const auto step = truth_.find(t_s);
    if (step == truth_.end() || step->second.count(index) == 0) return Verdict::Unknown;
    const int truth = step->second.at(index);
    const auto associations = filter.associations();
    if (const auto pair = associations.find(index); pair != associations.end())
        return valueOr(trueOf_, pair->second, truth - 1) == truth ? Verdict::TruePositive
                                                                  : Verdict::FalsePositive;
    if (truth < 0) return Verdict::TrueNegative;  // clutter
    const auto inserted = filter.inserted();
    const auto added = inserted.find(index);
    const bool known = std::any_of(trueOf_.begin(), trueOf_.end(),
                                   [truth](const auto& entry) { return entry.second == truth; });
    if (known) return Verdict::FalseNegative;
    if (added != inserted.end()) trueOf_[added->second] = truth;
    return Verdict::TrueNegative;
}

void AssociationLog::write(const mrpt::obs::CObservationBearingRange& observation,
                           const Filter& filter)
{
    const double t_s = mrpt::Clock::toDouble(observation.timestamp);
    const auto associations = filter.associations(), inserted = filter.inserted();
    char line[200];
    for (std::size_t i = 0; i < observation.sensedData.size(); ++i)
    {
        const auto& seen = observation.sensedData[i];
        const int landmark = valueOr(associations, i, valueOr(inserted, i, -1));
        std::snprintf(line, sizeof line, "%35.22f %8i %10i %10f %12f %12f\n", t_s,
                      static_cast<int>(i), landmark, static_cast<double>(seen.range),
                      static_cast<double>(seen.yaw), static_cast<double>(seen.pitch));
        if (associations_) associations_->write(line);

        const Verdict verdict = judge(t_s, i, filter);
        const auto is = [verdict](Verdict v) { return verdict == v ? 1 : 0; };
        std::snprintf(line, sizeof line, "%35.22f %13i %8i %8i %8i %8i %8i\n", t_s,
                      static_cast<int>(i), is(Verdict::TruePositive), is(Verdict::FalsePositive),
                      is(Verdict::TrueNegative), is(Verdict::FalseNegative), is(Verdict::Unknown));
        performance_.write(line);
    }
}
}  // namespace monoslam
