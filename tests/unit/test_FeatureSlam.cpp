// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/FeatureSlam.h"

#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <algorithm>
#include <stdexcept>

#include "monoslam_eval/PairCounts.h"
#include "monoslam_eval/simulate.h"

namespace monoslam::test
{
namespace
{
std::shared_ptr<const Associator> make(const std::string& strategy, const std::string& options = {})
{
    return makeAssociator(
        strategy, mrpt::config::CConfigFileMemory("[association." + strategy + "]\n" + options));
}

FeatureSlam slamOf(const Simulation& world, std::shared_ptr<const Associator> associator)
{
    return {FeatureSlamOptions{}, Camera(world.camera), std::move(associator), 1};
}

double error_m(const FeatureReport& report, const Vector13d& truth)
{
    return (report.x_v - truth).head<3>().norm();
}

SimulationOptions clean(int frames)
{
    SimulationOptions options;
    options.frames = frames;
    options.world.clutterPerImage = 0.0;
    options.world.detectionProbability = 1.0;
    return options;
}
}  // namespace

TEST(FeatureSlam, FollowsACleanWorldToMillimetres)
{
    const Simulation world = simulate(clean(60), 3);
    FeatureSlam slam = slamOf(world, make("hohct"));
    PairCounts pairs;
    for (std::size_t i = 0; i < world.frames.size(); ++i)
    {
        const FeatureReport report = slam.process(world.frames[i]);
        EXPECT_LT(error_m(report, world.path[i]), 0.015) << i;
        EXPECT_EQ(report.t_s, world.frames[i].t_s);
        pairs.add(report.associations, world.frames[i]);
    }
    EXPECT_EQ(pairs.wrong, 0);
    EXPECT_GT(pairs.recall(), 0.95);
    EXPECT_NO_THROW(best(slam.mixture()).checkInvariant());
}

TEST(FeatureSlam, BeginsLandmarksOnlyWithTheirOwnImages)
{
    SimulationOptions options = clean(5);
    options.world.clutterPerImage = 20.0;
    const Simulation world = simulate(options, 4);
    FeatureSlam slam = slamOf(world, make("hohct"));
    EXPECT_EQ(best(slam.mixture()).landmarks.size(), 4);  // the target's
    static_cast<void>(slam.process(world.frames[0]));
    const Camera camera(world.camera);
    for (LandmarkId id = 4; id < 34; ++id)
    {
        const auto& features = world.frames[0].features;
        const bool seen = std::any_of(features.begin(), features.end(),
                                      [&](const PixelFeature& f)
                                      { return f.truth == id && camera.contains(f.z, 8.0); });
        EXPECT_EQ(best(slam.mixture()).find(id) >= 0, seen) << id;
    }
}

TEST(FeatureSlam, GoesOnFromACopyWithTheSameBits)
{
    const Simulation world = simulate(SimulationOptions{}, 5);
    FeatureSlam slam = slamOf(world, make("mhda"));
    for (std::size_t i = 0; i < 10; ++i) static_cast<void>(slam.process(world.frames[i]));
    FeatureSlam copy = slam;
    for (std::size_t i = 10; i < 20; ++i)
    {
        EXPECT_EQ(slam.process(world.frames[i]).x_v, copy.process(world.frames[i]).x_v);
        EXPECT_EQ(best(slam.mixture()).P, best(copy.mixture()).P);
    }
}

TEST(FeatureSlam, RefusesTimeThatStandsStillAndUnknownTruth)
{
    const Simulation world = simulate(clean(2), 6);
    FeatureSlam slam = slamOf(world, make("hohct"));
    static_cast<void>(slam.process(world.frames[0]));
    EXPECT_THROW(slam.process(world.frames[0]), std::invalid_argument);
    PixelFrame unknown = world.frames[1];
    unknown.features[0].truth = kUnknownTruth;
    EXPECT_THROW(slam.process(unknown), std::invalid_argument);
}

TEST(FeatureSlamOptions, AreReadAndChecked)
{
    const mrpt::config::CConfigFileMemory good("[slam]\nsigma_px = 2\nrho0_per_m = 0.7\n");
    const FeatureSlamOptions options = FeatureSlamOptions::from(good, "a.ini");
    EXPECT_EQ(options.visibility.sigma_px, 2.0);
    EXPECT_EQ(options.prior.sigma_px, 2.0);
    EXPECT_EQ(options.prior.rho0, 0.7);
    const mrpt::config::CConfigFileMemory bad("[slam]\nrho0 = 0.7\n");
    EXPECT_THROW(FeatureSlamOptions::from(bad, "a.ini"), std::invalid_argument);
}
}  // namespace monoslam::test
