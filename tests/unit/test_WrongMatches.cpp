// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "rowWorld.h"

namespace monoslam::test
{
TEST(WrongMatches, ShiftAGroupInTheImageForItsFramesAndNothingElse)
{
    const SyntheticWorld calm = rowOf(6, quiet());
    SyntheticWorld world = rowOf(6, quiet());
    WrongMatches group;
    group.landmarks = {1, 2, 4};
    group.firstFrame = 10;
    group.frames = 3;
    group.offset_px = {7.0, -5.0};
    world.add(group);
    for (const long frame : {9L, 13L})
        EXPECT_TRUE(same(world.observe(atOrigin(), frame), calm.observe(atOrigin(), frame)));
    for (long frame = 10; frame < 13; ++frame)
    {
        const PixelFrame wrong = world.observe(atOrigin(), frame);
        const PixelFrame right = calm.observe(atOrigin(), frame);
        for (LandmarkId id = 0; id < 6; ++id)
        {
            const bool inGroup = id == 1 || id == 2 || id == 4;
            EXPECT_EQ(find(wrong, id, id).has_value(), !inGroup);
            if (!inGroup)
            {
                EXPECT_EQ(find(wrong, id, id)->z, find(right, id, id)->z);
                continue;
            }
            const auto image = find(wrong, id, kOfNoLandmark);
            ASSERT_TRUE(image);
            const Eigen::Vector2d there = *world.truePixel(atOrigin(), id) + group.offset_px;
            EXPECT_LT((image->z - there).norm(), 5.0 * 0.5);
        }
    }
}

TEST(WrongMatches, OfATwinAreImagesOfOneShiftedObjectFromAnywhere)
{
    SyntheticWorld world = rowOf(4, quiet());
    WrongMatches group;
    group.landmarks = {0, 3};
    group.frames = 5;
    group.shift_m = {0.0, 0.2, 0.1};
    group.trueHidden = false;
    world.add(group);
    Vector13d x_v = atOrigin();
    for (long frame = 0; frame < 5; ++frame)
    {
        x_v[0] += 0.05;
        const PixelFrame seen = world.observe(x_v, frame);
        for (const LandmarkId id : group.landmarks)
        {
            EXPECT_TRUE(find(seen, id, id));
            const auto twin = find(seen, id, kOfNoLandmark);
            ASSERT_TRUE(twin);
            const auto there = projectPixel(world.camera(), x_v, LandmarkKind::Point,
                                            world.position(id) + group.shift_m);
            EXPECT_LT((twin->z - *there).norm(), 5.0 * 0.5);
        }
    }
}

TEST(LandmarkMotion, IsSeenButIsNoLongerRight)
{
    SyntheticWorld world = rowOf(2, quiet());
    world.add(LandmarkMotion{1, 10, {0.0, 0.3, 0.0}});
    EXPECT_TRUE(find(world.observe(atOrigin(), 10), 1, 1));
    const PixelFrame later = world.observe(atOrigin(), 40);
    EXPECT_FALSE(find(later, 1, 1));
    const auto moved = find(later, 1, kOfNoLandmark);
    ASSERT_TRUE(moved);
    EXPECT_NEAR(moved->z.y(), 239.5 + 500.0 * 0.3 / 2.0, 3.0);  // 0.3 m after 1 s, 2 m away
    EXPECT_TRUE(find(later, 0, 0));
}
}  // namespace monoslam::test
