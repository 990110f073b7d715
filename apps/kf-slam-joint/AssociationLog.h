// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/obs/CObservationBearingRange.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "Filter.h"
#include "monoslam_slam/writers.h"

namespace monoslam
{
/** data_association.log and data_association_performance.log, as kf-slam writes them. */
class AssociationLog
{
   public:
    /** \param truth  file of time, index in the observation, landmark; or empty */
    AssociationLog(const std::string& folder, bool withAssociations, const std::string& truth);

    void write(const mrpt::obs::CObservationBearingRange& observation, const Filter& filter);

   private:
    enum class Verdict
    {
        TruePositive,
        FalsePositive,
        TrueNegative,
        FalseNegative,
        Unknown
    };
    [[nodiscard]] Verdict judge(double t_s, std::size_t index, const Filter& filter);

    std::unique_ptr<OutputFile> associations_;
    OutputFile performance_;
    std::map<double, std::map<std::size_t, int>>
        truth_;                          ///< true landmark by time and index; < 0 is clutter
    std::map<std::size_t, int> trueOf_;  ///< true landmark of those of the map
};
}  // namespace monoslam
