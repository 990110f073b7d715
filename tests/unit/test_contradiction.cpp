// SPDX-License-Identifier: BSD-3-Clause
#include "contradiction.h"

#include <gtest/gtest.h>

#include "LinearWorld.h"

namespace monoslam::test
{
namespace
{
constexpr int kLandmarks = 40;

/** The first \p matched landmarks of a world matched, the others missed. */
std::vector<Association> firstMatched(int matched)
{
    std::vector<Association> all(kLandmarks);
    for (int i = 0; i < kLandmarks; ++i)
    {
        all[static_cast<std::size_t>(i)].id = i;
        all[static_cast<std::size_t>(i)].fate = i < matched ? Fate::Matched : Fate::NotFound;
    }
    return all;
}

/** Only the first \p count landmarks are in the image. */
LinearWorld worldThatShows(int count)
{
    LinearWorld world = LinearWorld::withLandmarks(kLandmarks, 3, 0.5);
    for (int i = count; i < kLandmarks; ++i) world.seen.erase(i);
    return world;
}
}  // namespace

TEST(Contradiction, IsWhatWasMissedButIsInTheImage)
{
    const LinearWorld world = worldThatShows(kLandmarks);
    EXPECT_TRUE(isContradicted(firstMatched(6), world.belief, world.view()));
    EXPECT_TRUE(isContradicted(firstMatched(15), world.belief, world.view()));
}

TEST(Contradiction, IsNotWhatIsHidden)
{
    const LinearWorld world = worldThatShows(10);
    EXPECT_FALSE(isContradicted(firstMatched(10), world.belief, world.view()));
    EXPECT_FALSE(isContradicted(firstMatched(0), worldThatShows(0).belief, world.view()));
}

TEST(Contradiction, NeedsMoreWitnessesThanTheMatchesAre)
{
    // 17 of 34 or 18 of 22 missed ones are seen: too few against a half, or against 18 matches.
    const LinearWorld half = worldThatShows(23);
    EXPECT_FALSE(isContradicted(firstMatched(6), half.belief, half.view()));
    LinearWorld most = worldThatShows(kLandmarks);
    for (int id : {20, 24, 28, 32, 36}) most.seen.erase(id);
    EXPECT_FALSE(isContradicted(firstMatched(18), most.belief, most.view()));
}

TEST(Contradiction, IsNotLookedForWhereHalfIsMatched)
{
    LinearWorld world = worldThatShows(kLandmarks);
    int searches = 0;
    FrameView view = world.view();
    view.search = [&](const SearchRegion& region)
    {
        ++searches;
        return world.search(region);
    };
    EXPECT_FALSE(isContradicted(firstMatched(20), world.belief, view));
    EXPECT_FALSE(isContradicted({}, world.belief, view));
    EXPECT_EQ(searches, 0);
    EXPECT_TRUE(isContradicted(firstMatched(1), world.belief, view));
    EXPECT_LE(searches, 16);
}
}  // namespace monoslam::test
