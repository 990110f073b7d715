// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "OutputFolder.h"
#include "ProcessPool.h"
#include "TemporaryFolder.h"
#include "lastLine.h"
#include "results.h"
#include "writeDurably.h"

namespace monoslam
{
namespace
{
JobRecord exampleRecord()
{
    JobRecord record;
    record.done = true;
    record.wall_s = 1.5;
    record.figures = {{"z_mm", 0.1}, {"a", nullptr}, {"lost", false}, {"note", "one, \"two\""}};
    return record;
}

TEST(JobRecord, IsReadAsItWasWritten)
{
    const TemporaryFolder folder;
    EXPECT_FALSE(readRecord(folder.path()));
    const JobRecord written = exampleRecord();
    writeRecord(folder.path(), written);
    const auto read = readRecord(folder.path());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->done, written.done);
    EXPECT_EQ(read->wall_s, written.wall_s);
    EXPECT_EQ(read->figures.dump(), written.figures.dump());
}

TEST(JobRecord, ThatIsCutAnywhereIsNone)
{
    const TemporaryFolder folder;
    writeRecord(folder.path(), exampleRecord());
    const std::string file = folder / kRecordFile;
    const std::string text = readText(file);
    for (std::size_t size = 0; size + 2 < text.size(); ++size)
    {
        writeText(file, text.substr(0, size));
        EXPECT_FALSE(readRecord(folder.path())) << size;
    }
}

TEST(JobRecord, ARunThatLeftNoSummaryIsAnError)
{
    const TemporaryFolder folder;
    EXPECT_THROW(static_cast<void>(recordOf(folder.path(), false)), std::runtime_error);
}

TEST(JobRecord, AFailureHasTheLastLineAndTheSignal)
{
    const TemporaryFolder folder;
    writeText(folder / kLogFile, "first\nmono-slam: no camera \n\n");
    EXPECT_EQ(failureOf(folder.path(), 1).error, "mono-slam: no camera");
    EXPECT_EQ(failureOf(folder.path(), 139).error,
              "ended by signal 11 after: mono-slam: no camera");
}

TEST(LastLine, IsWhatATerminalShowsLast)
{
    const TemporaryFolder folder;
    writeText(folder / "log", "one\n[##..] 1/2\r[####] 2/2\n");
    EXPECT_EQ(lastLineOf(folder / "log"), "[####] 2/2");
    EXPECT_EQ(lastLineOf(folder / "none"), "");
}

TEST(WriteDurably, LeavesTheOldContentWhereTheDiskIsFull)
{
    const TemporaryFolder folder;
    writeDurably(folder / "file", "old");
    std::filesystem::create_symlink("/dev/full", folder / "file.part");
    EXPECT_THROW(writeDurably(folder / "file", "new"), std::runtime_error);
    EXPECT_EQ(readText(folder / "file"), "old");
}

TEST(ResultsCsv, HasARowAJobWhateverHasEnded)
{
    Job job;
    job.sequence = "s";
    job.strategy = "nn";
    job.variant = "v";
    job.folder = "f";
    std::vector<Job> jobs(3, job);
    jobs[1].seed = 2;
    jobs[2].seed = 3;
    JobRecord failed;
    failed.status = 1;
    failed.error = "a: b, c";
    const JobRecords records{failed, std::nullopt, exampleRecord()};
    EXPECT_EQ(resultsCsv(jobs, records),
              "sequence,strategy,variant,seed,status,exit_status,error,folder,time_wall_s,z_mm,a,"
              "lost,note\n"
              "s,nn,v,1,failed,1,\"a: b, c\",f,,,,,\n"
              "s,nn,v,2,pending,,,f,,,,,\n"
              "s,nn,v,3,done,0,,f,1.5,0.1,,0,\"one, \"\"two\"\"\"\n");
}

TEST(OutputFolder, OfSomebodyElseIsRefused)
{
    const TemporaryFolder folder;
    writeText(folder / "precious.txt", "mine");
    EXPECT_THROW(OutputFolder(folder.path(), false), std::runtime_error);
    {
        const OutputFolder forced(folder.path(), true);
    }
    const OutputFolder ours(folder.path(), false);
    EXPECT_EQ(readText(folder / "precious.txt"), "mine");
}

TEST(OutputFolder, ServesOneBatchAtATime)
{
    const TemporaryFolder folder;
    const OutputFolder first(folder.path(), false);
    EXPECT_THROW(OutputFolder(folder.path(), false, std::chrono::milliseconds(50)),
                 std::runtime_error);
}

std::vector<TaskEnd> runAll(const std::vector<Task>& tasks, std::size_t slots)
{
    std::vector<TaskEnd> all;
    std::size_t most = 0;
    runTasks(tasks, slots,
             [&](const std::vector<TaskEnd>& ends, std::size_t running)
             {
                 all.insert(all.end(), ends.begin(), ends.end());
                 most = std::max(most, running);
             });
    EXPECT_LE(most, slots);
    return all;
}

TEST(ProcessPool, EndsATaskWithItsFirstProgramThatFails)
{
    const TemporaryFolder folder;
    const auto sh = [](const std::string& script) { return Command{"/bin/sh", "-c", script}; };
    const std::vector<Task> tasks{
        {0, {sh("echo a"), sh("echo b >&2"), sh("exit 3"), sh("echo c")}, folder / "0"},
        {1, {sh("kill -SEGV $$")}, folder / "1"},
        {2, {sh("echo d"), sh("echo e")}, folder / "2"}};
    auto ends = runAll(tasks, 2);
    ASSERT_EQ(ends.size(), 3U);
    std::sort(ends.begin(), ends.end(), [](auto& a, auto& b) { return a.id < b.id; });
    EXPECT_EQ(ends[0].status, 3);
    EXPECT_EQ(ends[1].status, 139);
    EXPECT_EQ(ends[2].status, 0);
    EXPECT_EQ(readText(folder / "0"), "a\nb\n");
    EXPECT_EQ(readText(folder / "2"), "d\ne\n");
}

TEST(ProcessPool, NamesAProgramThatCannotBeStarted)
{
    const TemporaryFolder folder;
    EXPECT_THROW(runAll({{0, {{"/no/such/program"}}, folder / "0"}}, 1), std::runtime_error);
}
}  // namespace
}  // namespace monoslam
