// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <set>

#include "Job.h"
#include "commands.h"
#include "parseSeeds.h"
#include "runProgram.h"

namespace monoslam
{
namespace
{
using Seeds = std::vector<unsigned>;

Batch exampleBatch()
{
    Batch batch;
    batch.fileName = "batch.ini";
    for (const char* name : {"lab", "desk"})
    {
        Sequence s;
        s.name = name;
        s.section = std::string("sequence.") + name;
        s.rawlog = std::string("/data/") + name + ".rawlog";
        s.config = "/data/base.ini";
        s.truth = "/data/truth.txt";
        s.settings = {"map.strikes=3"};
        batch.sequences.push_back(s);
    }
    batch.strategies = {"jcbb", "hohct"};
    batch.variants = {{"plain", {}, {}}, {"tight", {"association.hohct.tau=0.9"}, {"hohct"}}};
    batch.seeds = {4, 2};
    return batch;
}

TEST(ParseSeeds, ListsAndRanges)
{
    EXPECT_EQ(parseSeeds("1-3, 7 9"), (Seeds{1, 2, 3, 7, 9}));
    EXPECT_EQ(parseSeeds("5"), (Seeds{5}));
    EXPECT_EQ(parseSeeds("0-0"), (Seeds{0}));
    EXPECT_EQ(parseSeeds("4294967294-4294967295"), (Seeds{4294967294U, 4294967295U}));
}

TEST(ParseSeeds, RefusesWhatIsNoSeed)
{
    for (const char* text : {"", " , ", "3-1", "-1", "1-", "1-2-3", "a", "1.5", "1 1", "1-3 2",
                             "4294967296", "0-4000000000", "1 -3"})
        EXPECT_FALSE(parseSeeds(text)) << text;
}

TEST(ExpandJobs, TheSeedChangesFastestAndTheFilesOrderIsKept)
{
    const auto jobs = expandJobs(exampleBatch());
    std::vector<std::string> names;
    for (const Job& job : jobs)
        names.push_back(job.sequence + " " + job.strategy + " " + job.variant + " " +
                        std::to_string(job.seed));
    EXPECT_EQ(names, (std::vector<std::string>{
                         "lab jcbb plain 4", "lab jcbb plain 2", "lab hohct plain 4",
                         "lab hohct plain 2", "lab hohct tight 4", "lab hohct tight 2",
                         "desk jcbb plain 4", "desk jcbb plain 2", "desk hohct plain 4",
                         "desk hohct plain 2", "desk hohct tight 4", "desk hohct tight 2"}));
}

TEST(ExpandJobs, NoTwoJobsShareAFolder)
{
    std::set<std::string> folders;
    const auto jobs = expandJobs(exampleBatch());
    for (const Job& job : jobs) folders.insert(job.folder);
    EXPECT_EQ(folders.size(), jobs.size());
}

TEST(ExpandJobs, AVariantComesAfterItsSequence)
{
    Batch batch = exampleBatch();
    batch.variants = {{"v", {"map.strikes=5"}, {}}};
    const Command slam = expandJobs(batch).front().slam;
    EXPECT_EQ(slam,
              (Command{"/data/base.ini", "/data/lab.rawlog", "--set", "association.strategy=jcbb",
                       "--set", "map.strikes=3", "--set", "map.strikes=5"}));
}

/** Folders of the jobs in one batch that another does not have. */
std::size_t changed(const Batch& batch)
{
    std::set<std::string> before;
    for (const Job& job : expandJobs(exampleBatch())) before.insert(job.folder);
    std::size_t count = 0;
    for (const Job& job : expandJobs(batch)) count += 1 - before.count(job.folder);
    return count;
}

TEST(ExpandJobs, OnlyWhatIsConfiguredOtherwiseGetsAnotherFolder)
{
    Batch batch = exampleBatch();
    EXPECT_EQ(changed(batch), 0U);
    batch.variants[1].settings = {"association.hohct.tau=0.8"};
    EXPECT_EQ(changed(batch), 4U);
    batch = exampleBatch();
    batch.sequences[0].settings.emplace_back("map.strikes=4");
    EXPECT_EQ(changed(batch), 6U);
    batch = exampleBatch();
    batch.sequences[1].fingerprint = "another content";
    EXPECT_EQ(changed(batch), 6U);
    batch = exampleBatch();
    batch.seeds.push_back(9);
    EXPECT_EQ(changed(batch), 6U);
}

TEST(ExpandJobs, AFolderMovedAsAWholeKeepsItsJobs)
{
    Batch batch = exampleBatch();
    for (Sequence& s : batch.sequences) s.rawlog = "/elsewhere" + s.rawlog;
    EXPECT_EQ(changed(batch), 0U);
}

TEST(ShellWord, ComesThroughAShellAsItIs)
{
    for (const std::string word : {"plain/word-1.5", "two words", "it's", "$HOME `id` \\ \"x\"", "",
                                   "*", "a;b&c|d", "#no", "~", "new\nline", "ä"})
        EXPECT_EQ(runShell("printf %s " + shellWord(word)).output, word);
}

TEST(ShellLine, OneLineThatEndsByRecordingTheJob)
{
    const Job job = expandJobs(exampleBatch()).front();
    const std::string line = shellLineOf(job, "/the bin", "/out");
    EXPECT_EQ(line.rfind("'/the bin/mono-slam' /data/base.ini", 0), 0U) << line;
    EXPECT_NE(line.find(" --seed 4 "), std::string::npos) << line;
    EXPECT_NE(line.find(" && '/the bin/mono-slam-eval' --groundtruth /data/truth.txt"),
              std::string::npos);
    const std::string end = " && '/the bin/mono-slam-batch' --finish /out/" + job.folder;
    EXPECT_EQ(line.substr(line.size() - end.size()), end);
}

TEST(ShellLine, WithoutTruthNothingIsEvaluated)
{
    Batch batch = exampleBatch();
    batch.sequences[0].truth.clear();
    EXPECT_EQ(commandsOf(expandJobs(batch).front(), "/bin", "/out").size(), 1U);
    batch.sequences[0].outAndBack = true;
    EXPECT_EQ(commandsOf(expandJobs(batch).front(), "/bin", "/out").size(), 2U);
}
}  // namespace
}  // namespace monoslam
