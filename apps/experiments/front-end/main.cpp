// SPDX-License-Identifier: BSD-3-Clause
// Bias and standard deviation of the matches against rendered truth.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>

#include "MatchErrors.h"
#include "TrueWorld.h"
#include "monoslam_eval/metrics.h"

namespace monoslam
{
namespace
{
constexpr double kSmooth = 0.005;  ///< bend of a patch that counts as one plane
constexpr double kSteady = 0.02;   ///< variation of depth of a patch that faces the camera
constexpr double kDegree = 0.017453292519943295;

struct Birth
{
    long frame = 0;
    Eigen::Vector2d uv_px;
};

/** Matches of one run beside the true pixels of their landmarks. */
struct RunErrors
{
    std::vector<MatchError> matches;
    double ate_m = 0.0;  ///< after SE3 alignment
    double scale = 1.0;  ///< of the Sim3 alignment
};

RunErrors runErrors(const RenderedSequence& sequence, TrueWorld& world, const RunSettings& settings,
                    int half_px)
{
    RunErrors errors;
    Trajectory estimate;
    std::map<LandmarkId, Birth> births;
    const auto visit = [&](const Frame& frame, const FrameReport& report, const MonoSlam& slam)
    {
        for (const Association& seen : report.associations)
        {
            const auto birth = births.find(seen.id);
            if (seen.fate != Fate::Matched || birth == births.end()) continue;
            const auto [born, born_px] = birth->second;
            const auto p_w = world.point(born, born_px);
            const auto truth = p_w ? world.pixel(frame.index, *p_w) : std::nullopt;
            const auto patch = world.patchDepth(born, born_px, half_px);
            if (!truth || !patch) continue;
            const Eigen::Vector3d then = *p_w - world.eye(born);
            const Eigen::Vector3d now = *p_w - world.eye(frame.index);
            MatchError error;
            error.id = seen.id;
            error.age = frame.index - born;
            error.scale = then.norm() / now.norm();
            error.viewAngle_deg =
                std::acos(std::min(1.0, then.normalized().dot(now.normalized()))) / kDegree;
            error.e_px = seen.z - *truth;
            error.R = seen.R;
            error.patchVariation = patch->variation;
            error.patchBend = patch->bend;
            error.hidden = world.isHidden(frame.index, *p_w);
            errors.matches.push_back(error);
        }
        for (const MapLandmark& landmark : slam.map())
            births[landmark.id] = {landmark.bornFrame, landmark.born_px};
        if (report.hasPose())
            estimate.push_back({report.t_s, report.x_v.head<3>(),
                                report.x_v.segment<4>(camera_state::kOrientation)});
    };
    runSequence(sequence, settings, visit);
    const auto pairs = matchByTime(estimate, readTum(sequence.folder + "/groundtruth.txt"));
    errors.ate_m = trajectoryErrors(pairs, Alignment::SE3).position_m.rmse;
    errors.scale = align(pairs, Alignment::Sim3).s;
    return errors;
}

using Test = std::function<bool(const MatchError&)>;

void printLine(const std::string& name, const std::vector<MatchError>& errors, const Test& test)
{
    std::vector<MatchError> chosen;
    std::copy_if(errors.begin(), errors.end(), std::back_inserter(chosen), test);
    std::fputs(tableLine(name, figuresOf(chosen)).c_str(), stdout);
}

bool isSmooth(const MatchError& e)
{
    return e.patchBend < kSmooth && !e.hidden;
}

void printRange(const std::string& name, const std::vector<MatchError>& errors,
                const std::function<double(const MatchError&)>& of, double low, double high)
{
    printLine(name, errors,
              [&](const MatchError& e) { return isSmooth(e) && of(e) >= low && of(e) < high; });
}

void printTable(const std::string& title, const RunErrors& run)
{
    std::printf("\n### %s: ATE %.2f mm, scale %.4f\n\n%s", title.c_str(), 1e3 * run.ate_m,
                run.scale, tableHead().c_str());
    const std::vector<MatchError>& errors = run.matches;
    printLine("all", errors, [](const MatchError&) { return true; });
    printLine("hidden in truth", errors, [](const MatchError& e) { return e.hidden; });
    printLine("birth patch across an edge", errors,
              [](const MatchError& e) { return !e.hidden && !isSmooth(e); });
    printLine("birth patch on one plane", errors, isSmooth);
    printLine("of these depth varies < 2 %", errors,
              [](const MatchError& e) { return isSmooth(e) && e.patchVariation < kSteady; });
    const auto age = [](const MatchError& e) { return static_cast<double>(e.age); };
    printRange("age 1-5 frames", errors, age, 1, 6);
    printRange("age 6-20", errors, age, 6, 21);
    printRange("age 21-60", errors, age, 21, 61);
    printRange("age 61 and more", errors, age, 61, 1e9);
    const auto scale = [](const MatchError& e) { return e.scale; };
    printRange("scale below 0.80", errors, scale, 0, 0.8);
    printRange("scale 0.80-0.95", errors, scale, 0.8, 0.95);
    printRange("scale 0.95-1.05", errors, scale, 0.95, 1.05);
    printRange("scale 1.05-1.25", errors, scale, 1.05, 1.25);
    printRange("scale above 1.25", errors, scale, 1.25, 1e9);
    const auto angle = [](const MatchError& e) { return e.viewAngle_deg; };
    printRange("view angle 0-5 deg", errors, angle, 0, 5);
    printRange("view angle 5-15 deg", errors, angle, 5, 15);
    printRange("view angle 15-30 deg", errors, angle, 15, 30);
    printRange("view angle above 30 deg", errors, angle, 30, 180);
    std::fflush(stdout);
}

int run(int argc, char** argv)
{
    if (argc < 4)
    {
        std::fprintf(stderr, "%s CONFIG.ini SEQUENCE DEPTH_FOLDER [section.key=value]...\n",
                     argv[0]);
        return 2;
    }
    RunSettings settings;
    settings.configFile = argv[1];
    const RenderedSequence sequence = readRenderedSequence(argv[2]);
    TrueWorld world(sequence, argv[3]);
    settings.overrides.assign(argv + 4, argv + argc);
    const int half_px = SearchOptions{}.patch_px / 2;
    printTable("Sub-pixel alignment", runErrors(sequence, world, settings, half_px));
    settings.overrides.emplace_back("search.subpixel=false");
    printTable("Integer peaks", runErrors(sequence, world, settings, half_px));
    return 0;
}
}  // namespace
}  // namespace monoslam

int main(int argc, char** argv)
{
    try
    {
        return monoslam::run(argc, argv);
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
        return 1;
    }
}
