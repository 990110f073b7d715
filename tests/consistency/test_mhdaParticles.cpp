// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <mrpt/config/CConfigFileMemory.h>

#include <string>

#include "monoslam_eval/FeatureSlam.h"
#include "monoslam_eval/simulate.h"

namespace monoslam::test
{
namespace
{
double lastError_m(const Simulation& world, const std::string& options)
{
    const mrpt::config::CConfigFileMemory ini("[association.mhda]\n" + options);
    FeatureSlam slam(FeatureSlamOptions{}, Camera(world.camera), makeAssociator("mhda", ini), 1);
    double error_m = 0.0;
    for (std::size_t i = 0; i < world.frames.size(); ++i)
        error_m = (slam.process(world.frames[i]).x_v - world.path[i]).head<3>().norm();
    return error_m;
}
}  // namespace

/** One particle cannot undo its first pair of a frame, which has the widest ellipse. If that is
 *  clutter, every other landmark is outside its own ellipse: nothing is found, unless others are
 *  drawn. */
TEST(Mhda, OneParticleIsLostInClutterUnlessItIsDrawnAgainOrFourAre)
{
    int lostAlone = 0, lostRedrawn = 0, lostOfFour = 0;
    for (unsigned seed = 1; seed <= 6; ++seed)
    {
        SimulationOptions options;
        options.frames = 110;
        const Simulation world = simulate(options, seed);
        lostAlone += lastError_m(world, "particles = 1\nredraws = 0\n") > 0.1 ? 1 : 0;
        lostRedrawn += lastError_m(world, "particles = 1\n") > 0.1 ? 1 : 0;
        lostOfFour += lastError_m(world, "particles = 4\nredraws = 0\n") > 0.1 ? 1 : 0;
    }
    EXPECT_GE(lostAlone, 2);
    EXPECT_EQ(lostRedrawn, 0);
    EXPECT_EQ(lostOfFour, 0);
}
}  // namespace monoslam::test
