// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "TemporaryFolder.h"
#include "exampleRawlog.h"
#include "runProgram.h"

namespace monoslam
{
/** results.csv without the columns that begin with "time_"; fields have no comma in these tests. */
inline std::string withoutTimes(const std::string& csv)
{
    std::istringstream lines(csv);
    std::vector<bool> kept;
    std::string text;
    for (std::string line; std::getline(lines, line);)
    {
        std::istringstream fields(line + ",");
        std::size_t column = 0;
        for (std::string field; std::getline(fields, field, ','); ++column)
        {
            if (text.find('\n') == std::string::npos) kept.push_back(field.rfind("time_", 0) != 0);
            if (kept.at(column)) text += field + ",";
        }
        text += "\n";
    }
    return text;
}

/** Two small rawlogs, their base configuration and a batch of 2 x 2 x 1 x 1 jobs of them. */
class BatchFolder : public testing::Test
{
   protected:
    BatchFolder()
    {
        for (const char* name : {"a", "b"})
            writeExampleRawlog(folder_ / (std::string(name) + ".rawlog"), exampleTimes(12));
        writeText(folder_ / "base.ini", "[map]\nstrikes = 3\n");
        writeBatch();
    }

    void writeBatch(const std::string& batch = "strategies = spatial_nn jcbb\n",
                    const std::string& rest = "") const
    {
        writeText(ini_, "[batch]\noutput = out\n" + batch +
                            "[sequence.all]\nrawlog = *.rawlog\nconfig = base.ini\n" + rest);
    }

    [[nodiscard]] ProgramResult batch(const std::string& arguments = {},
                                      const std::string& prefix = {}) const
    {
        return runProgram("mono-slam-batch", "'" + ini_ + "' " + arguments, prefix);
    }

    [[nodiscard]] std::string results(const std::string& output = "out") const
    {
        return readText(folder_ / (output + "/results.csv"));
    }

    /** Exit status 1 and one line that holds all the words. */
    static void expectOneLine(const ProgramResult& result, const std::vector<std::string>& words)
    {
        EXPECT_EQ(result.status, 1) << result.output;
        EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
        for (const auto& word : words)
            EXPECT_NE(result.output.find(word), std::string::npos)
                << word << " not in: " << result.output;
    }

    TemporaryFolder folder_;
    std::string ini_ = folder_ / "batch.ini";
};
}  // namespace monoslam
