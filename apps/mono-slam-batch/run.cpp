// SPDX-License-Identifier: BSD-3-Clause
#include "run.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "Interrupt.h"
#include "OutputFolder.h"
#include "checkJobs.h"
#include "commands.h"
#include "monoslam_association/Associator.h"
#include "monoslam_mrpt/registerMrptAssociators.h"
#include "runJobs.h"

namespace monoslam
{
namespace fs = std::filesystem;

namespace
{
constexpr int kSignalBase = 128;

/** mono-slam and mono-slam-eval stand beside this program. */
std::string programFolder()
{
    return fs::read_symlink("/proc/self/exe").parent_path().string();
}

void finish(const std::string& folder)
{
    // Whether the job is evaluated is not known here; its line has written figures.json if it is.
    writeRecord(folder, recordOf(folder, fs::exists(folder + "/" + kFiguresFile)));
}

JobRecords readRecords(const std::vector<Job>& jobs, const std::string& output, bool retryFailed)
{
    JobRecords records;
    for (const Job& job : jobs)
    {
        auto record = readRecord(output + "/" + job.folder);
        if (record && !record->done && retryFailed) record.reset();
        records.push_back(std::move(record));
    }
    return records;
}

std::vector<Job> withoutRecord(const std::vector<Job>& jobs, const JobRecords& records)
{
    std::vector<Job> pending;
    for (std::size_t i = 0; i < jobs.size(); ++i)
        if (!records[i]) pending.push_back(jobs[i]);
    return pending;
}

/** One line for people. \return whether a job has failed */
bool summarise(const JobRecords& records, const std::string& where)
{
    const auto done =
        std::count_if(records.begin(), records.end(), [](const auto& r) { return r && r->done; });
    const auto pending =
        std::count_if(records.begin(), records.end(), [](const auto& r) { return !r; });
    const auto failed = static_cast<std::ptrdiff_t>(records.size()) - done - pending;
    std::printf("%zu jobs: %td done, %td failed, %td pending; %s\n", records.size(), done, failed,
                pending, where.c_str());
    return failed > 0;
}

/** Checks and runs what is pending, and writes results.csv. */
int runBatch(const std::vector<Job>& jobs, const RunOptions& options, const Arguments& arguments)
{
    // Where the lines of --list have run there is no mark of ours yet, but there are our jobs.
    const bool ours =
        withoutRecord(jobs, readRecords(jobs, options.output, false)).size() < jobs.size();
    const OutputFolder folder(options.output, arguments.force || ours);
    JobRecords records = readRecords(jobs, options.output, arguments.retryFailed);
    noteInterrupts();
    if (!arguments.collect && !arguments.skipChecks)
        checkJobs(withoutRecord(jobs, records), options.programs, options.slots);
    if (!arguments.collect && interruptSignal() == 0) runJobs(jobs, records, options);
    writeResults(options.output, jobs, records);
    const bool failed = summarise(records, options.output + "/results.csv");
    if (interruptSignal() != 0) return kSignalBase + interruptSignal();
    const bool complete = withoutRecord(jobs, records).empty();
    return !failed && (complete || arguments.collect) ? 0 : 1;
}
}  // namespace

int run(const Arguments& arguments)
{
    if (!arguments.finish.empty())
    {
        finish(arguments.finish);
        return 0;
    }
    registerMrptAssociators();
    const Batch batch = readBatch(arguments.batchFile, associatorNames());
    const std::vector<Job> jobs = expandJobs(batch);
    RunOptions options{programFolder(), batch.output, arguments.jobs};
    if (!arguments.output.empty())
        options.output = fs::absolute(arguments.output).lexically_normal().string();
    if (arguments.list)
    {
        for (const Job& job : jobs)
            std::printf("%s\n", shellLineOf(job, options.programs, options.output).c_str());
        return 0;
    }
    if (!arguments.dryRun) return runBatch(jobs, options, arguments);
    noteInterrupts();
    checkJobs(jobs, options.programs, options.slots);
    if (interruptSignal() != 0) return kSignalBase + interruptSignal();
    summarise(readRecords(jobs, options.output, arguments.retryFailed), options.output);
    return 0;
}
}  // namespace monoslam
