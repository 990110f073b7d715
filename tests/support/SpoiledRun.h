// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "TemporaryFolder.h"
#include "exampleRawlog.h"
#include "runProgram.h"

namespace monoslam
{
/** A good rawlog of 30 frames and an ini; each test spoils one thing and runs mono-slam. */
class SpoiledRun : public testing::Test
{
   protected:
    SpoiledRun()
    {
        writeExampleRawlog(rawlog_, exampleTimes(30));
        writeText(ini_, "[rawlog]\nfile = good.rawlog\n");
    }

    [[nodiscard]] ProgramResult run(const std::string& more = {},
                                    const std::string& prefix = {}) const
    {
        return runProgram("mono-slam", "'" + ini_ + "' --output '" + out_ + "' " + more, prefix);
    }

    /** Exit status 1 and one line that holds all the words. */
    void expectOneLine(const ProgramResult& result, const std::vector<std::string>& words) const
    {
        EXPECT_EQ(result.status, 1) << result.output;
        const auto line = result.output.find("mono-slam: ");
        ASSERT_NE(line, std::string::npos) << result.output;
        const std::string message = result.output.substr(line);
        EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << message;
        for (const auto& word : words)
            EXPECT_NE(message.find(word), std::string::npos) << word << " not in: " << message;
    }

    /** Lines of an output file. */
    [[nodiscard]] long linesOf(const std::string& name) const
    {
        const std::string text = readText(out_ + "/" + name);
        return std::count(text.begin(), text.end(), '\n');
    }

    /** An output file of lines, each with its line end and as many fields as the first. */
    void expectCompleteTable(const std::string& name) const
    {
        const std::string text = readText(out_ + "/" + name);
        ASSERT_FALSE(text.empty()) << name;
        EXPECT_EQ(text.back(), '\n') << name;
        std::istringstream lines(text);
        const auto separators = [](const std::string& line)
        {
            bool quoted = false;
            return std::count_if(line.begin(), line.end(),
                                 [&quoted](char c)
                                 {
                                     if (c == '"') quoted = !quoted;
                                     return !quoted && (c == ',' || c == ' ');
                                 });
        };
        std::string first, line;
        std::getline(lines, first);
        while (std::getline(lines, line)) EXPECT_EQ(separators(line), separators(first)) << line;
    }

    /** What an interrupted run leaves: every file, complete, and a summary that says so. */
    void expectResultsSoFar() const
    {
        for (const char* name : {"trajectory.tum", "covariance.csv", "frames.csv", "map.csv"})
            expectCompleteTable(name);
        for (const char* name : {"map.ply", "summary.json"})
        {
            const std::string text = readText(out_ + "/" + name);
            ASSERT_FALSE(text.empty()) << name;
            EXPECT_EQ(text.back(), '\n') << name;
        }
        EXPECT_TRUE(std::filesystem::exists(out_ + "/map.3Dscene"));
        EXPECT_NE(readText(out_ + "/summary.json").find("\"interrupted\": true"),
                  std::string::npos);
    }

    [[nodiscard]] std::string image(int index) const
    {
        char name[40];
        std::snprintf(name, sizeof name, "good_Images/%06d.png", index);
        return folder_ / name;
    }

    void rewriteWith(const std::vector<Ticks>& times) const
    {
        std::filesystem::remove_all(folder_ / "good_Images");
        std::filesystem::remove(rawlog_);
        writeExampleRawlog(rawlog_, times);
    }

    TemporaryFolder folder_;
    std::string rawlog_ = folder_ / "good.rawlog";
    std::string ini_ = folder_ / "run.ini";
    std::string out_ = folder_ / "out";
};
}  // namespace monoslam
