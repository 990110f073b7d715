// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_vision/Patch.h"

#include <gtest/gtest.h>

#include "texture.h"

namespace monoslam
{
namespace
{
TEST(SamplePatch, CopiesPixelsUnderTheIdentity)
{
    const Texture texture(2);
    Appearance first;
    first.image = prepareImage(
        renderImage(80, 60, [&](double u, double v) { return texture.at(u, v); }), 0.7);
    first.uv_px = {40, 30};
    const auto patch = samplePatch(first, PredictedWarp{}, 6);
    ASSERT_TRUE(patch);
    for (int dy = -7; dy <= 7; ++dy)
        for (int dx = -7; dx <= 7; ++dx)
            ASSERT_EQ(patch->at(dx, dy), first.image->levels[0].at<std::uint8_t>(30 + dy, 40 + dx));
    first.uv_px = {7, 30};
    EXPECT_TRUE(samplePatch(first, PredictedWarp{}, 6));
    first.uv_px = {6, 30};
    EXPECT_FALSE(samplePatch(first, PredictedWarp{}, 6));
}
}  // namespace
}  // namespace monoslam
