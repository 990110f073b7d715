// SPDX-License-Identifier: BSD-3-Clause
// Does validation of the matches help? none against hohct and jcbb, judged by rendered truth.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "Verdicts.h"
#include "drawPairs.h"
#include "monoslam_eval/metrics.h"

namespace monoslam
{
namespace
{
constexpr int kSeeds = 5;

struct Arguments
{
    std::string config;
    std::string sequence;
    std::string depth;     ///< folder; empty: the moving object is the truth
    std::string pictures;  ///< prefix of the pictures' names; empty = none
    std::vector<long> pictured;
};

/** One run's figures. */
struct RunFigures
{
    Verdicts verdicts;
    double ate_mm = 0.0;
    double scale = 1.0;
    long notTracking = 0;  ///< frames degraded or lost
};

void savePicture(const Arguments& arguments, const std::string& strategy, const Frame& frame,
                 const std::vector<JudgedPair>& pairs)
{
    char name[64];
    std::snprintf(name, sizeof name, "-%s-%04ld.jpg", strategy.c_str(), frame.index);
    char title[64];
    std::snprintf(title, sizeof title, "%s, frame %ld", strategy.c_str(), frame.index);
    const std::string file = arguments.pictures + name;
    if (!cv::imwrite(file, drawPairs(frame.image, pairs, title), {cv::IMWRITE_JPEG_QUALITY, 85}))
        throw std::runtime_error(file + ": cannot be written");
}

RunFigures runOnce(const Arguments& arguments, const RenderedSequence& sequence,
                   const RunSettings& settings, Judge& judge)
{
    RunFigures figures;
    Trajectory estimate;
    const bool mayDraw = settings.seed == 1 && !arguments.pictures.empty();
    const auto visit = [&](const Frame& frame, const FrameReport& report, const MonoSlam& slam)
    {
        std::vector<JudgedPair> pairs;
        for (const Association& pair : report.associations)
        {
            if (pair.fate != Fate::Matched && pair.fate != Fate::Rejected) continue;
            pairs.push_back({pair, judge.isWrong(pair, frame.index)});
            figures.verdicts.add(pairs.back().wrong, pair.fate == Fate::Rejected);
        }
        judge.note(slam.map());
        if (report.hasPose())
            estimate.push_back({report.t_s, report.x_v.head<3>(),
                                report.x_v.segment<4>(camera_state::kOrientation)});
        if (report.state != TrackingState::Tracking) ++figures.notTracking;
        const auto& frames = arguments.pictured;
        if (mayDraw && std::find(frames.begin(), frames.end(), frame.index) != frames.end())
            savePicture(arguments, settings.strategy, frame, pairs);
    };
    runSequence(sequence, settings, visit);
    const auto matched = matchByTime(estimate, readTum(sequence.folder + "/groundtruth.txt"));
    figures.ate_mm = 1e3 * trajectoryErrors(matched, Alignment::SE3).position_m.rmse;
    figures.scale = trajectoryErrors(matched, Alignment::Sim3).alignment.s;
    return figures;
}

void printLine(const std::string& strategy, std::vector<RunFigures> runs)
{
    Verdicts sum;
    long notTracking = 0;
    for (const RunFigures& run : runs)
    {
        sum.rightAccepted += run.verdicts.rightAccepted;
        sum.wrongAccepted += run.verdicts.wrongAccepted;
        sum.rightRejected += run.verdicts.rightRejected;
        sum.wrongRejected += run.verdicts.wrongRejected;
        notTracking += run.notTracking;
    }
    std::sort(runs.begin(), runs.end(),
              [](const RunFigures& a, const RunFigures& b) { return a.ate_mm < b.ate_mm; });
    const RunFigures& middle = runs[runs.size() / 2];
    std::printf("| %s | %ld | %ld | %ld | %.3f | %.3f | %ld | %.2f | %.2f | %+.2f | %ld |\n",
                strategy.c_str(), sum.pairs(), sum.wrongAccepted + sum.wrongRejected,
                sum.rightRejected + sum.wrongRejected, sum.precision(), sum.recall(),
                sum.wrongAccepted, middle.ate_mm, runs.back().ate_mm, 100.0 * (middle.scale - 1.0),
                notTracking);
    std::fflush(stdout);
}

Arguments parse(int argc, char** argv)
{
    if (argc < 4)
        throw std::invalid_argument(
            "CONFIG.ini SEQUENCE DEPTH_FOLDER|motion [PICTURE_PREFIX FRAME...]");
    Arguments arguments{argv[1], argv[2], argv[3], argc > 4 ? argv[4] : "", {}};
    if (arguments.depth == "motion") arguments.depth.clear();
    for (int i = 5; i < argc; ++i) arguments.pictured.push_back(std::stol(argv[i]));
    return arguments;
}

int run(const Arguments& arguments)
{
    const RenderedSequence sequence = readRenderedSequence(arguments.sequence);
    TrueWorld world(sequence, arguments.depth);
    ObjectPolygons object;
    if (arguments.depth.empty()) object = readObjectPolygons(arguments.sequence);
    std::puts(
        "| strategy | pairs | wrong | rejected | precision | recall | wrong accepted | "
        "ATE median [mm] | ATE worst [mm] | scale error [%] | frames not tracking |\n"
        "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
    for (const std::string strategy : {"none", "hohct", "jcbb"})
    {
        std::vector<RunFigures> runs;
        for (unsigned seed = 1; seed <= kSeeds; ++seed)
        {
            RunSettings settings;
            settings.configFile = arguments.config;
            settings.strategy = strategy;
            settings.seed = seed;
            DepthJudge byDepth(world);
            MotionJudge byMotion(object);
            Judge& judge = arguments.depth.empty() ? static_cast<Judge&>(byMotion) : byDepth;
            runs.push_back(runOnce(arguments, sequence, settings, judge));
        }
        printLine(strategy, std::move(runs));
    }
    return 0;
}
}  // namespace
}  // namespace monoslam

int main(int argc, char** argv)
{
    try
    {
        return monoslam::run(monoslam::parse(argc, argv));
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
        return 1;
    }
}
