// SPDX-License-Identifier: BSD-3-Clause
#include "dismissMatches.h"

#include <gtest/gtest.h>

namespace monoslam
{
namespace
{
std::vector<Association> fates(int matched, int rejected, int notFound, int notSearched = 0)
{
    std::vector<Association> all;
    const auto add = [&all](int count, Fate fate)
    {
        for (int i = 0; i < count; ++i)
        {
            Association association;
            association.id = static_cast<LandmarkId>(all.size());
            association.fate = fate;
            all.push_back(association);
        }
    };
    add(matched, Fate::Matched);
    add(rejected, Fate::Rejected);
    add(notFound, Fate::NotFound);
    add(notSearched, Fate::NotSearched);
    return all;
}

Belief cameraAt(double x_m)
{
    Vector13d x_v = Vector13d::Zero();
    x_v(0) = x_m;
    x_v(camera_state::kOrientation) = 1.0;
    return Belief::ofCamera(x_v, 1e-4 * Matrix13d::Identity());
}
}  // namespace

TEST(DismissMatches, FewMatchesAreChanceWhenManyWereSearchedOrThePoseIsNotFixed)
{
    MapOptions map;
    map.min_matched = 5;
    EXPECT_TRUE(mayBeChance(fates(2, 0, 0), map));
    EXPECT_FALSE(mayBeChance(fates(3, 0, 0), map));
    EXPECT_FALSE(mayBeChance(fates(3, 3, 4), map));     // 3 of 10
    EXPECT_TRUE(mayBeChance(fates(3, 3, 5), map));      // 3 of 11
    EXPECT_FALSE(mayBeChance(fates(3, 3, 4, 9), map));  // what was not searched says nothing
    EXPECT_FALSE(mayBeChance(fates(5, 0, 45), map));
}

TEST(DismissMatches, LeaveThePredictionAndCountAsRejected)
{
    Correction correction;
    correction.mixture = {{cameraAt(1.0), -1.0}, {cameraAt(2.0), -2.0}, {cameraAt(3.0), -3.0}};
    correction.associations = fates(2, 1, 4);
    correction.counters.rejected = 1;
    correction.ofEveryBelief = {fates(2, 1, 4), fates(0, 1, 6), fates(1, 1, 5)};
    correction.parents = {1, 0, 1};
    const Correction only = dismissMatches(correction, cameraAt(0.0), 1);
    ASSERT_EQ(only.mixture.size(), 1U);
    EXPECT_EQ(only.mixture.front().belief.x(0), 0.0);
    EXPECT_EQ(only.counters.rejected, 3);
    EXPECT_EQ(only.parents, std::vector<std::size_t>{1});
    ASSERT_EQ(only.ofEveryBelief.size(), 1U);
    ASSERT_EQ(only.associations.size(), 7U);
    for (std::size_t i = 0; i < 7; ++i)
    {
        EXPECT_EQ(only.associations[i].fate, i < 3 ? Fate::Rejected : Fate::NotFound);
        EXPECT_EQ(only.ofEveryBelief.front()[i].fate, only.associations[i].fate);
    }
}
}  // namespace monoslam
