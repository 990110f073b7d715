// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <algorithm>
#include <string>

#include "LinearWorld.h"

namespace monoslam::test
{
/** One frame of a strategy with its default options but for \p ini, which begins in [association]
 *  and is of a world with a belief and a view. */
template <typename World>
Correction run(const std::string& name, const World& world, const std::string& ini = {})
{
    const mrpt::config::CConfigFileMemory file("[association]\n" + ini);
    const auto associator = makeAssociator(name, file, "test.ini");
    std::mt19937 rng(7);
    return associator->correct({{world.belief, 0.0}}, world.view(), rng);
}

inline long count(const Correction& correction, Fate fate)
{
    return std::count_if(correction.associations.begin(), correction.associations.end(),
                         [fate](const Association& a) { return a.fate == fate; });
}

inline const Association& recordOf(const Correction& correction, LandmarkId id)
{
    return *std::find_if(correction.associations.begin(), correction.associations.end(),
                         [id](const Association& a) { return a.id == id; });
}

inline void expectSound(const Correction& correction, const LinearWorld& world)
{
    const AssociationCounters& c = correction.counters;
    EXPECT_EQ(correction.associations.size(), world.belief.landmarks.size());
    EXPECT_EQ(c.rejected, count(correction, Fate::Rejected));
    EXPECT_EQ(c.pairs, count(correction, Fate::Rejected) + count(correction, Fate::Matched));
    EXPECT_GE(c.searches, c.pairs + count(correction, Fate::NotFound));
    EXPECT_EQ(c.pixelsCorrelated, 100 * c.searches);
    EXPECT_GE(c.searchMs + c.selectMs + c.updateMs, 0.0);
    EXPECT_NO_THROW(best(correction.mixture).checkInvariant());
    EXPECT_GE(best(correction.mixture).P.diagonal().minCoeff(), -1e-9);
}
}  // namespace monoslam::test
