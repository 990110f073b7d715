// SPDX-License-Identifier: BSD-3-Clause
#include "run.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <stdexcept>

#include "Config.h"
#include "ProblemDump.h"
#include "Progress.h"
#include "RunOutputs.h"
#include "monoslam_association/strategyTable.h"
#include "monoslam_mrpt/makeEngine.h"
#include "monoslam_mrpt/registerMrptAssociators.h"

namespace monoslam
{
namespace
{
volatile std::sig_atomic_t interrupted = 0;

/** The first Ctrl-C ends the run after this frame; the second ends the program. */
void onInterrupt(int signal)
{
    interrupted = 1;
    std::signal(signal, SIG_DFL);
}

void describe(const RawlogReader& reader, const Config& config)
{
    const CameraParameters& c = reader.camera();
    std::printf(
        "%s: %ld frames of '%s'\ncamera %dx%d px, f %.3f %.3f, c %.3f %.3f, distortion %s\n",
        config.rawlog.file.c_str(), reader.frameCount(), reader.sensorLabel().c_str(), c.width_px,
        c.height_px, c.fx_px, c.fy_px, c.cx_px, c.cy_px, name(c.distortion.model).c_str());
    if (!reader.gaps().empty())
        std::printf("%zu gaps in time, the first: %s\n", reader.gaps().size(),
                    reader.gaps().front().c_str());
    std::fflush(stdout);
}

void processAll(RawlogReader& reader, MonoSlam& slam, RunOutputs& outputs)
{
    Progress progress(reader.frameCount());
    long done = 0;
    while (interrupted == 0)
    {
        const auto start = std::chrono::steady_clock::now();
        const auto frame = reader.next();
        if (!frame) break;
        const std::chrono::duration<double, std::milli> decode =
            std::chrono::steady_clock::now() - start;
        const FrameReport report = slam.process(*frame);
        outputs.add(*frame, report, slam, decode.count());
        progress.show(++done, name(report.state));
    }
}
/** After an error, which is the one to report: the disk may be full for these files too. */
bool keepResultsSoFar(const MonoSlam& slam, RunOutputs& outputs)
{
    try
    {
        outputs.finish(slam, true);
        return true;
    }
    catch (const std::exception&)
    {
        return false;
    }
}
}  // namespace

int run(const Arguments& arguments)
{
    if (!arguments.defaultConfigFile.empty())
    {
        writeTextFile(arguments.defaultConfigFile, defaultConfig(), arguments.force);
        return 0;
    }
    registerMrptAssociators();
    if (arguments.listStrategies)
    {
        std::printf("%s", strategyTable().c_str());
        return 0;
    }
    if (arguments.configFile.empty())
        throw std::invalid_argument("no CONFIG.ini is given; see --help");
    Config config = loadConfig(arguments);
    checkOutputFolder(config.output.directory, arguments.force);
    ProblemDump dump(arguments.dumpFolder, arguments.dumpFrames, arguments.force);
    RawlogReader reader(config.rawlog, config.camera);
    MonoSlam slam(config.slam, Camera(reader.camera()), std::move(config.associator),
                  arguments.seed, makeEngine(config.slam.engine));
    describe(reader, config);
    if (arguments.dryRun && !reader.damage().empty()) throw std::runtime_error(reader.damage());
    if (arguments.dryRun) return 0;

    RunOutputs outputs(config, arguments, reader);
    dump.attachTo(slam);
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
    try
    {
        processAll(reader, slam, outputs);
    }
    catch (const std::exception& e)
    {
        if (keepResultsSoFar(slam, outputs)) throw;
        throw std::runtime_error(e.what() + std::string("; the files of the end are incomplete"));
    }
    outputs.finish(slam, interrupted != 0);
    std::printf("%soutputs in %s\n", outputs.summary().text().c_str(),
                config.output.directory.c_str());
    if (interrupted != 0) return 130;
    if (!outputs.summary().hasPose())
        throw std::runtime_error(config.rawlog.file +
                                 ": no frame has a pose: " + outputs.lastRemark());
    return 0;
}
}  // namespace monoslam
