// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "SpoiledRun.h"
#include "appRuns.h"

namespace monoslam
{
namespace
{
const std::string kDumped = kDesk + " --set rawlog.frame_count=40 --dump-association ";

ProgramResult bench(const std::string& arguments)
{
    return runProgram("association-bench", arguments);
}

/** Fields of the line of one strategy in a table. */
std::vector<std::string> lineOf(const std::string& table, const std::string& strategy)
{
    const auto at = table.find("\n| " + strategy + " |");
    EXPECT_NE(at, std::string::npos) << strategy << " not in: " << table;
    std::istringstream line(table.substr(at + 1, table.find('\n', at + 1) - at - 1));
    std::vector<std::string> fields;
    for (std::string field; std::getline(line, field, '|');)
        fields.push_back(field.size() > 2 ? field.substr(1, field.size() - 2) : field);
    return fields;
}

/** A column of frames.csv. */
std::string valueOf(const std::string& file, const std::string& column, int frame)
{
    std::istringstream lines(readText(file));
    std::string header, line;
    std::getline(lines, header);
    while (std::getline(lines, line) && line.rfind(std::to_string(frame) + ",", 0) != 0)
    {
    }
    std::istringstream names(header), values(line);
    for (std::string name, value;
         std::getline(names, name, ',') && std::getline(values, value, ',');)
        if (name == column) return value;
    return "no " + column;
}

/** A CSV of figures without its times. */
std::string withoutTimes(const std::string& file)
{
    std::istringstream lines(readText(file));
    std::string kept;
    for (std::string line; std::getline(lines, line);)
    {
        std::istringstream fields(line);
        int i = 0;
        for (std::string field; std::getline(fields, field, ','); ++i)
            if (i < 11 || i > 14) kept += field + ",";
        kept += "\n";
    }
    return kept;
}

class BadBench : public SpoiledRun
{
   protected:
    static void expectError(const ProgramResult& result, const std::vector<std::string>& words)
    {
        EXPECT_EQ(result.status, 1) << result.output;
        EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
        EXPECT_EQ(result.output.rfind("association-bench: ", 0), 0U) << result.output;
        for (const std::string& word : words)
            EXPECT_NE(result.output.find(word), std::string::npos) << word << ": " << result.output;
    }
};
}  // namespace

TEST(AssociationBench, SolvesADumpedFrameAsThePipelineDidAndWithEveryStrategy)
{
    const TemporaryFolder folder;
    run(kDumped + quoted(folder / "dump") + " --dump-frames 20,30-31", folder / "out");
    run(kDesk + " --set rawlog.frame_count=40", folder / "plain");
    EXPECT_EQ(readText(folder / "out/trajectory.tum"), readText(folder / "plain/trajectory.tum"));
    const auto files = std::filesystem::directory_iterator(folder / "dump");
    EXPECT_EQ(std::distance(begin(files), end(files)), 3);
    const auto result =
        bench("--config " + kDesk + " " + quoted(folder / "dump/association_000030.json"));
    ASSERT_EQ(result.status, 0) << result.output;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 14 + 5);
    const auto hohct = lineOf(result.output, "hohct");
    EXPECT_EQ(hohct[2], valueOf(folder / "out/frames.csv", "matched", 30));
    EXPECT_EQ(hohct[3], valueOf(folder / "out/frames.csv", "rejected", 30));
    EXPECT_EQ(lineOf(result.output, "mhda")[4], "-");  // no truth
}

TEST(AssociationBench, WritesTheFiguresOfEveryFile)
{
    const TemporaryFolder folder;
    run(kDumped + quoted(folder / "dump") + " --dump-frames 20,30", folder / "out");
    const std::string csv = folder / "problems.csv";
    const auto result = bench("--config " + kDesk + " --strategies hohct,none --csv " +
                              quoted(csv) + " " + quoted(folder / "dump/association_000020.json") +
                              " " + quoted(folder / "dump/association_000030.json"));
    ASSERT_EQ(result.status, 0) << result.output;
    EXPECT_EQ(result.output, "");
    const std::string text = readText(csv);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 2 * 2);
    for (const int frame : {20, 30})
    {
        const std::string line = "," + std::to_string(frame) + ",hohct," +
                                 valueOf(folder / "out/frames.csv", "pairs", frame) + "," +
                                 valueOf(folder / "out/frames.csv", "matched", frame) + "," +
                                 valueOf(folder / "out/frames.csv", "rejected", frame) + ",";
        EXPECT_NE(text.find(line), std::string::npos) << line << " not in: " << text;
    }
}

/** All strategies but MRPT's, which a clock ends. */
TEST(AssociationBench, GivesTheSameFiguresForAnyNumberOfWorkers)
{
    const TemporaryFolder folder;
    const std::string grid =
        "--synthetic --landmarks 6,12 --candidates 1,3 --absent 0,2,5 --problems 12 --strategies "
        "active_matching,active_search,ccda,clam,cost_assignment,hohct,jcbb,mhda,one_point_ransac,"
        "spatial_nn,subam --csv ";
    ASSERT_EQ(bench(grid + quoted(folder / "a.csv") + " --workers 1").status, 0);
    const auto result =
        bench(grid + quoted(folder / "b.csv") + " --output " + quoted(folder / "b.md"));
    ASSERT_EQ(result.status, 0) << result.output;
    ASSERT_EQ(bench(grid + quoted(folder / "c.csv") + " --seed 2").status, 0);
    const std::string a = withoutTimes(folder / "a.csv");
    EXPECT_EQ(std::count(a.begin(), a.end(), '\n'), 1 + 11 * 10);
    EXPECT_TRUE(a == withoutTimes(folder / "b.csv"));
    EXPECT_FALSE(a == withoutTimes(folder / "c.csv"));
    const std::string tables = readText(folder / "b.md");
    EXPECT_NE(result.output.find(tables), std::string::npos);
    for (const char* head : {"m = 6, 1 candidate: 24 ", "m = 12, 3 candidates: 36 "})
        EXPECT_NE(tables.find(head), std::string::npos) << tables;
}

TEST(AssociationBench, EndsMrptsSearchAtItsCapAndCountsIt)
{
    const TemporaryFolder folder;
    const auto result = bench(
        "--synthetic --strategies jcbb_mrpt --landmarks 25 --candidates 4"
        " --absent 0 --problems 5 --set association.jcbb_mrpt.time_cap_s=0.01");
    ASSERT_EQ(result.status, 0) << result.output;
    EXPECT_EQ(lineOf(result.output, "jcbb_mrpt")[13], "5") << result.output;
}

TEST_F(BadBench, SaysWhatIsWrongWithTheCommandLine)
{
    expectError(bench(""), {"FILE", "--synthetic"});
    expectError(bench("--synthetic x.json"), {"FILE", "--synthetic"});
    expectError(bench("x.json --output y.md"), {"--output"});
    expectError(bench("--synthetic --landmarks 6,twelve"), {"--landmarks", "twelve"});
    expectError(bench("--synthetic --candidates 0"), {"--candidates", "1"});
    expectError(bench("--synthetic --landmarks 6 --absent 4"), {"--absent"});
    expectError(bench("--synthetic --problems 0"), {"--problems"});
    expectError(bench("--synthetic --strategies hohct,guess"), {"guess", "jcbb_mrpt"});
    expectError(bench("--synthetic --set map.strikes=3"), {"map.strikes"});
    expectError(bench("--synthetic --set association.jcb.tau=0.9"), {"[association.jcb]"});
    expectError(bench("--synthetic --set association.jcbb.tua=0.9"), {"[association.jcbb]", "tua"});
    expectError(bench("--synthetic --config none.ini"), {"none.ini"});
    writeText(folder_ / "mine.csv", "mine");
    expectError(bench("--synthetic --csv '" + (folder_ / "mine.csv") + "'"), {"--force"});
    EXPECT_EQ(readText(folder_ / "mine.csv"), "mine");
}

TEST_F(BadBench, SaysWhatIsWrongWithAFile)
{
    expectError(bench("none.json"), {"none.json", "no such"});
    expectError(bench("'" + ini_ + "'"), {"run.ini", "not an association problem"});
    const auto result = run("--set rawlog.frame_count=5 --dump-frames 4 --dump-association '" +
                            (folder_ / "dump") + "'");
    ASSERT_EQ(result.status, 0) << result.output;
    const std::string good = readText(folder_ / "dump/association_000004.json");
    ASSERT_FALSE(good.empty());
    writeText(folder_ / "half.json", good.substr(0, good.size() / 2));
    expectError(bench("'" + (folder_ / "half.json") + "'"), {"half.json", "cut off"});
    std::string typed = good;
    typed.replace(typed.find("\"fx_px\": "), 9, "\"fx_px\": \"many\", \"f\": ");
    writeText(folder_ / "typed.json", typed);
    expectError(bench("'" + (folder_ / "typed.json") + "'"), {"typed.json", "camera"});
}

TEST_F(BadBench, SaysWhatIsWrongWithADump)
{
    expectOneLine(run("--dump-frames 3"), {"--dump-frames", "--dump-association"});
    const std::string dump = " --dump-association '" + (folder_ / "dump") + "'";
    expectOneLine(run(dump + " --dump-frames 5-"), {"--dump-frames", "5-"});
    expectOneLine(run(dump + " --dump-frames 5-3"), {"--dump-frames", "5-3"});
    writeText(folder_ / "dump/precious.txt", "mine");
    expectOneLine(run(dump), {"dump", "not empty", "--force"});
    EXPECT_FALSE(std::filesystem::exists(out_ + "/frames.csv"));
}
}  // namespace monoslam
