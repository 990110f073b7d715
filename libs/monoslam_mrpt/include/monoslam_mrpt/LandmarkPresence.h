// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "monoslam_mrpt/export.h"

namespace monoslam
{
/** How sure it is that the landmarks of a map exist, as log-odds.
 *
 *      born: 0;   seen: + ln(P_D / (1 - P_D)), at most three of them;   missed in view: + ln(1 - P_D)
 *
 * Clutter is seen once. Landmarks are numbered as in the map; serials never change. */
class MONOSLAM_MRPT_EXPORT LandmarkPresence
{
   public:
    void born();
    void seen(std::size_t landmark, double p_detection);
    void missed(std::size_t landmark, double p_detection);
    /** Those that are less likely to exist than not, ascending. */
    [[nodiscard]] std::vector<std::size_t> absent() const;
    void erase(const std::vector<std::size_t>& landmarks);

    /** Whether it was seen in the step of its birth only. */
    [[nodiscard]] bool isNewborn(std::size_t landmark) const
    {
        return entries_.at(landmark).newborn;
    }
    [[nodiscard]] std::size_t count() const { return entries_.size(); }
    [[nodiscard]] std::size_t serial(std::size_t landmark) const
    {
        return entries_.at(landmark).serial;
    }

   private:
    struct Entry
    {
        std::size_t serial = 0;
        double logOdds = 0.0;
        bool newborn = true;
    };
    std::vector<Entry> entries_;
    std::size_t born_ = 0;
};
}  // namespace monoslam
