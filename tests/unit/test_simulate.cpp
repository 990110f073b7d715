// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/simulate.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <algorithm>
#include <stdexcept>

#include "monoslam_eval/SmoothPath.h"
#include "monoslam_models/quaternion.h"

namespace monoslam::test
{
namespace
{
SimulationOptions shortOne()
{
    SimulationOptions options;
    options.frames = 40;
    return options;
}

SimulationOptions withGroup(int landmarks)
{
    SimulationOptions options = shortOne();
    options.wrongMatches.landmarks = landmarks;
    options.wrongMatches.first_frame = 20;
    options.wrongMatches.frames = 4;
    return options;
}

bool samePixels(const PixelFrame& a, const PixelFrame& b)
{
    return std::equal(a.features.begin(), a.features.end(), b.features.begin(), b.features.end(),
                      [](const PixelFeature& p, const PixelFeature& q) { return p.z == q.z; });
}

SimulationOptions optionsFrom(const std::string& text)
{
    return SimulationOptions::from(mrpt::config::CConfigFileMemory(text), "a.ini");
}
}  // namespace

TEST(SmoothPath, BeginsAtTheOriginAndDiffersBySeed)
{
    Vector7d origin;
    origin << 0, 0, 0, 1, 0, 0, 0;
    const SmoothPath path(0.2, 0.1, 1), other(0.2, 0.1, 2);
    EXPECT_LT((path.at(0.0).head<7>() - origin).norm(), 1e-12);
    EXPECT_LT((other.at(0.0).head<7>() - origin).norm(), 1e-12);
    EXPECT_GT((path.at(2.0) - other.at(2.0)).norm(), 1e-2);
    EXPECT_EQ(path.at(2.0), SmoothPath(0.2, 0.1, 1).at(2.0));
}

TEST(SmoothPath, HasTheVelocitiesOfItsPoses)
{
    const SmoothPath path(0.2, 0.1, 3);
    constexpr double dt_s = 1e-3;
    for (const double t_s : {0.0, 0.7, 5.3})
    {
        const Vector13d now = path.at(t_s), next = path.at(t_s + dt_s);
        const Eigen::Vector3d moved = now.head<3>() + dt_s * now.segment<3>(7);
        EXPECT_LT((moved - next.head<3>()).norm(), 1e-5);
        const Eigen::Vector4d turned = quaternionProduct(
            now.segment<4>(3), quaternionExp(Eigen::Vector3d(dt_s * now.tail<3>())));
        EXPECT_LT((turned - next.segment<4>(3)).norm(), 1e-5);
    }
}

TEST(Simulate, GivesEveryFrameItsTruth)
{
    const Simulation world = simulate(shortOne(), 5);
    ASSERT_EQ(world.frames.size(), 40);
    ASSERT_EQ(world.path.size(), 40);
    ASSERT_EQ(world.landmarks.size(), 34);
    const Camera camera(world.camera);
    for (std::size_t i = 0; i < world.frames.size(); ++i)
    {
        long own = 0;
        for (const PixelFeature& feature : world.frames[i].features)
        {
            if (feature.truth < 0) continue;
            ++own;
            const auto uv = projectPixel(camera, world.path[i], LandmarkKind::Point,
                                         world.landmarks[static_cast<std::size_t>(feature.truth)]);
            EXPECT_LT((feature.z - *uv).norm(), 5.0 * 0.5);
        }
        EXPECT_GT(own, 10);
    }
    const TargetOptions target;
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_LT((world.landmarks[i] - target.points()[i]).norm(), 5.0 * target.sigma_m);
}

TEST(Simulate, SpoilsNeighboursAndLeavesAllElseAsItWas)
{
    const Simulation calm = simulate(shortOne(), 6), spoiled = simulate(withGroup(5), 6);
    ASSERT_EQ(spoiled.wrongGroup.size(), 5);
    EXPECT_TRUE(calm.wrongGroup.empty());
    const std::vector<LandmarkId>& group = spoiled.wrongGroup;
    EXPECT_GE(*std::min_element(group.begin(), group.end()), 4);  // none of the target
    for (std::size_t i = 0; i < 40; ++i)
    {
        EXPECT_EQ(calm.path[i], spoiled.path[i]);
        EXPECT_EQ(samePixels(calm.frames[i], spoiled.frames[i]), i < 20 || i >= 24) << i;
    }
    // Nothing in view lies between the first of them, the middle, and the last.
    const Camera camera(spoiled.camera);
    const auto pixel = [&](LandmarkId id)
    {
        return projectPixel(camera, spoiled.path[20], LandmarkKind::Point,
                            spoiled.landmarks[static_cast<std::size_t>(id)])
            .value_or(Eigen::Vector2d(1e6, 1e6));
    };
    const double reach_px = (pixel(group.back()) - pixel(group.front())).norm();
    for (LandmarkId id = 4; id < 34; ++id)
    {
        const bool other = std::count(group.begin(), group.end(), id) == 0;
        EXPECT_FALSE(other && camera.contains(pixel(id)) &&
                     (pixel(id) - pixel(group.front())).norm() < reach_px);
    }
}

TEST(Simulate, MovesAsManyAsItIsTold)
{
    SimulationOptions options = shortOne();
    options.moving.landmarks = 3;
    options.moving.first_frame = 10;
    const Simulation world = simulate(options, 7);
    ASSERT_EQ(world.moved.size(), 3);
    for (std::size_t i = 11; i < 40; ++i)
        for (const PixelFeature& feature : world.frames[i].features)
            EXPECT_EQ(std::count(world.moved.begin(), world.moved.end(), feature.truth), 0);
}

TEST(Simulate, SaysHowManyAreInViewIfTheyAreTooFew)
{
    try
    {
        static_cast<void>(simulate(withGroup(1000), 1));
        FAIL();
    }
    catch (const std::invalid_argument& error)
    {
        EXPECT_NE(std::string(error.what()).find("[wrong_matches] landmarks = 1000: only"),
                  std::string::npos)
            << error.what();
    }
}

TEST(SimulationOptions, ReadWhatIsThereAndRefuseWhatIsNot)
{
    const SimulationOptions options = optionsFrom(
        "[simulation]\nframe_rate_hz = 50\nclutter_per_image = 3\n[wrong_matches]\nkind = twin\n"
        "hide_true = false\n[moving]\nspeed_mps = 2\n[path]\namplitude_m = 0.3\n");
    EXPECT_DOUBLE_EQ(options.world.frame_s, 0.02);
    EXPECT_EQ(options.world.clutterPerImage, 3.0);
    EXPECT_EQ(options.wrongMatches.kind, WrongMatchesOptions::Kind::Twin);
    EXPECT_FALSE(options.wrongMatches.hide_true);
    EXPECT_EQ(options.moving.speed_mps, 2.0);
    EXPECT_EQ(options.amplitude_m, 0.3);
    for (const char* text :
         {"[simulation]\nsigma = 1", "[simulation]\nsigma_px = 0", "[path]\namplitude = 1",
          "[target]\nwidth_m = -1", "[wrong_matches]\nkind = shifted", "[moving]\nspeed = 1",
          "[simulation]\nnearest_m = 6", "[simulation]\ndetection_probability = 1.5"})
        EXPECT_THROW(optionsFrom(text), std::invalid_argument) << text;
}
}  // namespace monoslam::test
