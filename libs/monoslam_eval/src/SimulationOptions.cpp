// SPDX-License-Identifier: BSD-3-Clause
#include "monoslam_eval/SimulationOptions.h"

#include "monoslam_support/ConfigSection.h"

namespace monoslam
{
namespace
{
constexpr Range kProbability{0.0, 1.0};
constexpr Range kNotNegative{0.0, kPositive.highest};
constexpr Range kFrames{0.0, 1e6};
constexpr Range kLandmarks{0.0, 1e4};
}  // namespace

TargetOptions TargetOptions::from(ConfigSection section)
{
    TargetOptions o;
    o.width_m = section.get("width_m", o.width_m, kPositive);
    o.height_m = section.get("height_m", o.height_m, kPositive);
    o.distance_m = section.get("distance_m", o.distance_m, kPositive);
    o.sigma_m = section.get("sigma_m", o.sigma_m, kPositive);
    section.rejectUnknownKeys();
    return o;
}

std::vector<Eigen::Vector3d> TargetOptions::points() const
{
    std::vector<Eigen::Vector3d> points;
    for (const double x : {-0.5 * width_m, 0.5 * width_m})
        for (const double y : {-0.5 * height_m, 0.5 * height_m})
            points.emplace_back(x, y, distance_m);
    return points;
}

WrongMatchesOptions WrongMatchesOptions::from(ConfigSection section)
{
    WrongMatchesOptions o;
    o.landmarks = section.get("landmarks", o.landmarks, kLandmarks);
    o.first_frame = section.get("first_frame", o.first_frame, kFrames);
    o.frames = section.get("frames", o.frames, kFrames);
    o.kind = section.get<Kind>("kind", o.kind, {{"offset", Kind::Offset}, {"twin", Kind::Twin}});
    o.offset_px = section.get("offset_px", o.offset_px, kNotNegative);
    o.shift_m = section.get("shift_m", o.shift_m, kNotNegative);
    o.hide_true = section.get("hide_true", o.hide_true);
    section.rejectUnknownKeys();
    return o;
}

MovingOptions MovingOptions::from(ConfigSection section)
{
    MovingOptions o;
    o.landmarks = section.get("landmarks", o.landmarks, kLandmarks);
    o.first_frame = section.get("first_frame", o.first_frame, kFrames);
    o.speed_mps = section.get("speed_mps", o.speed_mps, kNotNegative);
    section.rejectUnknownKeys();
    return o;
}

SimulationOptions::SimulationOptions()
{
    world.sigma_px = 0.5;
    world.detectionProbability = 0.9;
    world.clutterPerImage = 20.0;
}

SimulationOptions SimulationOptions::from(const mrpt::config::CConfigFileBase& file,
                                          const std::string& fileName)
{
    SimulationOptions o;
    SyntheticWorldOptions& w = o.world;
    ConfigSection simulation(file, "simulation", fileName);
    o.frames = simulation.get("frames", o.frames, {1.0, kFrames.highest});
    o.landmarks = simulation.get("landmarks", o.landmarks, kLandmarks);
    o.nearest_m = simulation.get("nearest_m", o.nearest_m, kPositive);
    o.farthest_m = simulation.get("farthest_m", o.farthest_m, kPositive);
    w.frame_s = 1.0 / simulation.get("frame_rate_hz", 1.0 / w.frame_s, {0.1, 1e4});
    w.sigma_px = simulation.get("sigma_px", w.sigma_px, kPositive);
    w.detectionProbability =
        simulation.get("detection_probability", w.detectionProbability, kProbability);
    w.clutterPerImage = simulation.get("clutter_per_image", w.clutterPerImage, {0.0, 1e4});
    w.minScore = simulation.get("min_zncc", w.minScore, {-1.0, 1.0 - 1e-6});
    w.scoreDecay = simulation.get("score_decay", w.scoreDecay, {1e-6, 1e3});
    simulation.rejectUnknownKeys();
    if (o.farthest_m < o.nearest_m)
        simulation.fail("farthest_m", "must not be less than nearest_m");
    ConfigSection path(file, "path", fileName);
    o.amplitude_m = path.get("amplitude_m", o.amplitude_m, kNotNegative);
    o.amplitude_rad = path.get("amplitude_rad", o.amplitude_rad, kNotNegative);
    path.rejectUnknownKeys();
    o.target = TargetOptions::from({file, "target", fileName});
    o.wrongMatches = WrongMatchesOptions::from({file, "wrong_matches", fileName});
    o.moving = MovingOptions::from({file, "moving", fileName});
    return o;
}
}  // namespace monoslam
