// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "monoslam_eval/simulate.h"
#include "monoslam_mrpt/RawlogWriter.h"
#include "monoslam_mrpt/cameraFrom.h"
#include "monoslam_slam/writers.h"
#include "run.h"

namespace monoslam
{
namespace
{
mrpt::poses::CPose3D toPose(const Vector13d& x_v)
{
    return {mrpt::math::CQuaternionDouble(x_v[3], x_v[4], x_v[5], x_v[6]), x_v[0], x_v[1], x_v[2]};
}

/** Exact: simulated times are whole ticks. */
Ticks ticksOfSeconds(double t_s)
{
    const Ticks second = ticksOf(clockOf(0) + std::chrono::seconds(1));
    return static_cast<Ticks>(std::llround(t_s * static_cast<double>(second)));
}

void writeRawlog(const Arguments& arguments, const Simulation& world)
{
    RawlogWriterOptions options;
    options.file = arguments.output;
    options.embed = true;  // there are no images that would need a folder
    options.force = arguments.force;
    options.camera = toTCamera(world.camera);
    RawlogWriter writer(options);
    for (std::size_t i = 0; i < world.frames.size(); ++i)
    {
        const Ticks t = ticksOfSeconds(world.frames[i].t_s);
        writer.addTruth(t, toPose(world.path[i]));
        writer.addFeatures(t, world.frames[i].features);
    }
    writer.close();
}

std::string tumOf(const Simulation& world)
{
    std::string lines;
    for (std::size_t i = 0; i < world.frames.size(); ++i)
        lines += tumLine(world.frames[i].t_s, world.path[i].head<camera_state::kPoseSize>());
    return lines;
}
}  // namespace

void writeSimulation(const Arguments& arguments, const Config& config)
{
    const std::string truth =
        std::filesystem::path(arguments.output).replace_extension(".tum").string();
    if (std::filesystem::exists(truth) && !arguments.force)
        throw std::runtime_error(truth + ": exists; use --force to replace it");
    const Simulation world = simulate(config.simulation, arguments.seed);
    writeRawlog(arguments, world);
    writeTextFile(truth, tumOf(world), arguments.force);
    std::size_t features = 0;
    for (const PixelFrame& frame : world.frames) features += frame.features.size();
    std::printf("%s: %zu frames, %zu features; true path in %s\n", arguments.output.c_str(),
                world.frames.size(), features, truth.c_str());
}
}  // namespace monoslam
