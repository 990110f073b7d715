// SPDX-License-Identifier: BSD-3-Clause
// What becomes of the camera when a group of landmarks is matched wrongly for some frames.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "disturbedRuns.h"
#include "monoslam_mrpt/registerMrptAssociators.h"
#include "runSeeds.h"

namespace monoslam
{
namespace
{
struct Scene
{
    const char* title;
    Disturbance disturbance;
    unsigned seeds;
    bool everyMhda;  ///< its variants as well
};

const std::vector<Scene> kScenes{{"A common offset of 10 px, the true images hidden",
                                  {WrongMatchesOptions::Kind::Offset, true},
                                  40,
                                  true},
                                 {"A twin of the object 50 mm away, the true images hidden",
                                  {WrongMatchesOptions::Kind::Twin, true},
                                  20,
                                  true},
                                 {"A common offset of 10 px beside the true images",
                                  {WrongMatchesOptions::Kind::Offset, false},
                                  20,
                                  false}};

struct Arguments
{
    unsigned threads = 2;
    std::vector<Scene> scenes = kScenes;
};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

/** Recovered [%]: median of the largest error while the group lasts > of the error after it. */
void printCell(const OutcomesOfSeeds& ofSeeds, std::size_t duration)
{
    long recovered = 0;
    std::vector<double> worst_mm, after_mm;
    for (const auto& outcomes : ofSeeds)
    {
        recovered += outcomes[duration].recovered() ? 1 : 0;
        worst_mm.push_back(1e3 * outcomes[duration].worst_m);
        after_mm.push_back(1e3 * outcomes[duration].after_m);
    }
    std::printf(" **%.0f**: ",
                100.0 * static_cast<double>(recovered) / static_cast<double>(ofSeeds.size()));
    if (kDurations[duration] > 0) std::printf("%.1f > ", median(worst_mm));
    std::printf("%.1f |", median(after_mm));
}

void printRow(const Method& method, const OutcomesOfSeeds& ofSeeds)
{
    double wrong = 0.0;
    std::vector<double> frame_ms;
    for (const auto& outcomes : ofSeeds)
    {
        wrong += static_cast<double>(outcomes.back().wrongMatched);
        frame_ms.push_back(outcomes.back().frame_ms);
    }
    std::printf("| %s |", method.name.c_str());
    for (std::size_t d = 0; d < kDurations.size(); ++d) printCell(ofSeeds, d);
    std::printf(" %.1f | %.2f |\n", wrong / static_cast<double>(ofSeeds.size()), median(frame_ms));
    std::fflush(stdout);
}

void printTable(const std::vector<Method>& methods, const Scene& scene, unsigned threads)
{
    std::printf("| |");
    for (const int duration : kDurations)
        std::printf(" %s |", duration == 0 ? "no group" : std::to_string(duration).c_str());
    std::printf(" wrong pairs | ms |\n|---|");
    for (std::size_t i = 0; i < kDurations.size() + 2; ++i) std::printf("--:|");
    std::printf("\n");
    for (const Method& method : methods)
        printRow(method, runSeeds(method, scene.disturbance, scene.seeds, threads));
    std::printf("\n");
}

unsigned numberFrom(const std::string& text, std::size_t most)
{
    const bool digits = text.find_first_not_of("0123456789") == std::string::npos;
    const unsigned long number = digits && text.size() < 7 && !text.empty() ? std::stoul(text) : 0;
    if (number < 1 || number > most)
        throw std::invalid_argument(text + ": expected a number from 1 to " + std::to_string(most));
    return static_cast<unsigned>(number);
}

Arguments parse(int argc, char** argv)
{
    if (argc > 3) throw std::invalid_argument("expected [THREADS [SCENE]]");
    constexpr std::size_t kMostThreads = 256;
    Arguments arguments;
    if (argc > 1) arguments.threads = numberFrom(argv[1], kMostThreads);
    if (argc > 2) arguments.scenes = {kScenes[numberFrom(argv[2], kScenes.size()) - 1]};
    return arguments;
}

void run(const Arguments& arguments)
{
    registerMrptAssociators();
    for (const Scene& scene : arguments.scenes)
    {
        std::printf("## %s, %u seeds\n\n### Every strategy\n\n", scene.title, scene.seeds);
        printTable(allStrategies(), scene, arguments.threads);
        if (!scene.everyMhda) continue;
        std::printf("### mhda\n\n");
        printTable(mhdaVariants(), scene, arguments.threads);
    }
}
}  // namespace
}  // namespace monoslam

int main(int argc, char** argv)
{
    try
    {
        monoslam::run(monoslam::parse(argc, argv));
        return 0;
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
        return 1;
    }
}
