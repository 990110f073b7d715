// SPDX-License-Identifier: BSD-3-Clause
#include "BatchFolder.h"

namespace monoslam
{
namespace
{
namespace fs = std::filesystem;
using BatchInput = BatchFolder;
const std::string kGood = "strategies = spatial_nn\n";

TEST_F(BatchInput, MissingFiles)
{
    fs::remove(ini_);
    expectOneLine(batch(), {"batch.ini", "no such"});
    writeBatch(kGood, "config = none.ini\n");
    expectOneLine(batch(), {"batch.ini: [sequence.all] config", "none.ini: no such file"});
    writeBatch(kGood, "truth = {folder}/{stem}.txt\n");
    expectOneLine(batch(), {"[sequence.all] truth", "a.txt: no such file"});
    writeBatch(kGood, "rawlog = c.rawlog\n");
    expectOneLine(batch(), {"[sequence.all] rawlog", "c.rawlog: no such file"});
    writeBatch(kGood, "rawlog = *.log\n");
    expectOneLine(batch(), {"[sequence.all] rawlog", "no file matches"});
}

TEST_F(BatchInput, UnknownSectionsKeysAndNames)
{
    writeBatch(kGood, "[sequences.b]\n");
    expectOneLine(batch(), {"batch.ini: [sequences.b]: unknown section", "sequence.NAME"});
    writeBatch(kGood + "seed = 2\n");
    expectOneLine(batch(), {"[batch]", "unknown keys: seed", "seeds"});
    writeBatch(kGood, "truht = x\n");
    expectOneLine(batch(), {"[sequence.all]", "unknown keys: truht", "truth"});
    writeBatch(kGood, "[variant.v]\nstrategy = jcbb\n");
    expectOneLine(batch(), {"[variant.v]", "unknown keys: strategy", "strategies"});
    writeBatch("strategies = guess\n");
    expectOneLine(batch(), {"[batch] strategies", "unknown: guess", "hohct"});
    writeBatch(kGood + "variants = v w\n", "[variant.v]\n");
    expectOneLine(batch(), {"[batch] variants", "unknown: w"});
    writeBatch(kGood, "[variant.a/b]\n");
    expectOneLine(batch(), {"[variant.a/b]", "letters"});
}

TEST_F(BatchInput, NothingToRun)
{
    writeBatch("strategies =\n");
    expectOneLine(batch(), {"[batch] strategies", "names nothing"});
    writeBatch("seeds = 1\n");
    expectOneLine(batch(), {"[batch] strategies", "not given"});
    for (const std::string seeds : {"", "3-1", "1 1", "x"})
    {
        writeBatch(kGood + "seeds = " + seeds + "\n");
        expectOneLine(batch(), {"[batch] seeds"});
    }
    writeText(ini_, "[batch]\noutput = out\nstrategies = jcbb\n");
    expectOneLine(batch(), {"batch.ini", "no section [sequence.NAME]"});
}

TEST_F(BatchInput, AnOverrideThatMonoSlamRefuses)
{
    writeBatch(kGood, "[variant.v]\nmap.strike = 3\n");
    const auto result = batch("--dry-run");
    expectOneLine(result, {"[sequence.all] (all.a)", "spatial_nn", "[variant.v]", "[map]",
                           "unknown keys: strike", "1 more"});
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    writeBatch(kGood, "association.strategy = jcbb\n");
    expectOneLine(batch(), {"[sequence.all] association.strategy", "[batch] strategies"});
}

TEST_F(BatchInput, ARawlogThatIsCutIsToldBeforeAnythingRuns)
{
    writeExampleRawlog(folder_ / "c.rawlog", exampleTimes(12));
    fs::resize_file(folder_ / "c.rawlog", fs::file_size(folder_ / "c.rawlog") / 2);
    expectOneLine(batch(), {"[sequence.all] (all.c)", "c.rawlog"});
    EXPECT_FALSE(fs::exists(folder_ / "out/jobs"));
    EXPECT_EQ(batch("--skip-checks").status, 1);
    EXPECT_NE(results().find("all.b,jcbb,default,1,done,0,"), std::string::npos) << results();
    EXPECT_NE(results().find("all.c,jcbb,default,1,failed,1,"), std::string::npos) << results();
}

TEST_F(BatchInput, OptionsThatContradict)
{
    EXPECT_EQ(runProgram("mono-slam-batch", "").status, 1);
    expectOneLine(batch("--list --collect"), {"--list, --collect"});
    expectOneLine(batch("--jobs 0"), {"--jobs 0"});
    expectOneLine(batch("--finish x"), {"--finish"});
}

TEST_F(BatchInput, AFolderOfSomebodyElse)
{
    writeText(folder_ / "out/precious.txt", "mine");
    expectOneLine(batch(), {"out: the output folder is not empty", "--force"});
    EXPECT_EQ(batch("--force").status, 0);
    EXPECT_EQ(readText(folder_ / "out/precious.txt"), "mine");
}
}  // namespace
}  // namespace monoslam
