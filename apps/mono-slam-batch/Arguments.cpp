// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include <tclap/CmdLine.h>

#include <algorithm>
#include <stdexcept>
#include <thread>

namespace monoslam
{
Arguments parseArguments(int argc, char** argv)
{
    using Text = TCLAP::ValueArg<std::string>;
    TCLAP::CmdLine cmd("Sequences x strategies x variants x seeds, run by mono-slam", ' ',
                       MONOSLAM_VERSION);
    TCLAP::UnlabeledValueArg<std::string> file(
        "batch", "What to run; config/batch_example.ini tells how", false, "", "BATCH.ini", cmd);
    Text output("", "output", "Folder for all outputs, instead of [batch] output", false, "", "DIR",
                cmd);
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    TCLAP::ValueArg<unsigned> jobs("", "jobs", "Processes at a time; default: one a core", false,
                                   cores, "N", cmd);
    TCLAP::SwitchArg list("", "list", "Print each job as one shell command, and end", cmd);
    TCLAP::SwitchArg collect("", "collect", "Write results.csv of the finished jobs, and end", cmd);
    TCLAP::SwitchArg dryRun("", "dry-run", "Check batch and overrides, and end", cmd);
    TCLAP::SwitchArg retry("", "retry-failed", "Run the jobs that failed once more", cmd);
    TCLAP::SwitchArg skip("", "skip-checks",
                          "Do not ask mono-slam first whether it takes rawlogs and overrides", cmd);
    TCLAP::SwitchArg force("", "force", "Use a folder that holds other files", cmd);
    Text finish("", "finish", "Record a job of --list as done, from its files, and end", false, "",
                "JOB_DIR", cmd);
    cmd.parse(argc, argv);

    Arguments a;
    a.batchFile = file.getValue();
    a.output = output.getValue();
    a.finish = finish.getValue();
    a.jobs = jobs.getValue();
    a.list = list.getValue();
    a.collect = collect.getValue();
    a.dryRun = dryRun.getValue();
    a.retryFailed = retry.getValue();
    a.skipChecks = skip.getValue();
    a.force = force.getValue();
    if (a.batchFile.empty() == a.finish.empty())
        throw std::invalid_argument("give either BATCH.ini or --finish JOB_DIR; see --help");
    if (a.list + a.collect + a.dryRun > 1)
        throw std::invalid_argument("give one of --list, --collect and --dry-run");
    if (a.jobs == 0) throw std::invalid_argument("--jobs 0: must be at least 1");
    return a;
}
}  // namespace monoslam
