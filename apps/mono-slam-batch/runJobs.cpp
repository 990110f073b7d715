// SPDX-License-Identifier: BSD-3-Clause
#include "runJobs.h"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include "ProcessPool.h"
#include "Progress.h"
#include "writeDurably.h"

namespace monoslam
{
namespace
{
using Clock = std::chrono::steady_clock;
constexpr auto kResultsInterval = std::chrono::seconds(2);
constexpr int kInterrupted = 130;  // mono-slam after Ctrl-C or SIGTERM

/** Ended from outside, not by itself: the job has no result, and runs again next time. */
bool wasInterrupted(int status)
{
    return status == kInterrupted || status == 128 + SIGTERM || status == 128 + SIGHUP;
}

JobRecord recordOfEnd(const Job& job, const TaskEnd& end, const std::string& folder)
{
    if (end.status != 0) return failureOf(folder, end.status);
    try
    {
        return recordOf(folder, !job.evaluate.empty());
    }
    catch (const std::exception& e)
    {
        JobRecord record;
        record.error = e.what();
        return record;
    }
}

std::vector<Task> tasksOf(const std::vector<Job>& jobs, const JobRecords& records,
                          const RunOptions& options)
{
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < jobs.size(); ++i)
    {
        if (records[i]) continue;
        const std::string folder = options.output + "/" + jobs[i].folder;
        std::filesystem::create_directories(folder);
        std::filesystem::remove(folder + "/" + kRecordFile);  // of a failure, now tried again
        tasks.push_back(
            {i, commandsOf(jobs[i], options.programs, options.output), folder + "/" + kLogFile});
    }
    return tasks;
}

std::string nameOf(const Job& job)
{
    return job.sequence + " " + job.strategy + " " + job.variant + " " + std::to_string(job.seed);
}

/** Failures always, successes where no progress bar tells them. */
void tell(const Job& job, const JobRecord& record)
{
    const bool onTerminal = isatty(STDERR_FILENO) != 0;
    if (record.done && onTerminal) return;
    std::fprintf(stderr, "%s%s: %s%s%s\n", onTerminal ? "\r\033[K" : "", nameOf(job).c_str(),
                 record.done ? "done" : "failed", record.done ? "" : ": ", record.error.c_str());
}
}  // namespace

void writeResults(const std::string& output, const std::vector<Job>& jobs,
                  const JobRecords& records)
{
    writeDurably(output + "/results.csv", resultsCsv(jobs, records));
}

void runJobs(const std::vector<Job>& jobs, JobRecords& records, const RunOptions& options)
{
    std::vector<Task> tasks = tasksOf(jobs, records, options);
    Progress progress(static_cast<long>(tasks.size()));
    long ended = 0;
    long failed = 0;
    auto written = Clock::now();
    const auto onPoll = [&](const std::vector<TaskEnd>& ends, std::size_t running)
    {
        for (const TaskEnd& end : ends)
        {
            ++ended;
            const Job& job = jobs[end.id];
            if (wasInterrupted(end.status)) continue;
            const std::string folder = options.output + "/" + job.folder;
            JobRecord record = recordOfEnd(job, end, folder);
            record.wall_s = end.wall_s;
            writeRecord(folder, record);
            failed += record.done ? 0 : 1;
            tell(job, record);
            records[end.id] = std::move(record);
        }
        progress.show(ended,
                      std::to_string(running) + " running, " + std::to_string(failed) + " failed");
        if (ends.empty() || Clock::now() - written < kResultsInterval) return;
        writeResults(options.output, jobs, records);
        written = Clock::now();
    };
    runTasks(std::move(tasks), options.slots, onPoll);
}
}  // namespace monoslam
