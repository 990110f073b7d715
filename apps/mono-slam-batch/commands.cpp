// SPDX-License-Identifier: BSD-3-Clause
#include "commands.h"

#include <algorithm>
#include <cctype>

#include "JobRecord.h"

namespace monoslam
{
namespace
{
bool isPlain(unsigned char c)
{
    return std::isalnum(c) != 0 ||
           std::string("_-+=./,:@%").find(static_cast<char>(c)) != std::string::npos;
}

Command slamOf(const Job& job, const std::string& programs, const std::string& folder)
{
    Command command{programs + "/mono-slam"};
    command.insert(command.end(), job.slam.begin(), job.slam.end());
    // A folder that an interrupted run began is used again; of a job it holds only our files.
    command.insert(command.end(),
                   {"--seed", std::to_string(job.seed), "--output", folder, "--force"});
    return command;
}
}  // namespace

std::string shellWord(const std::string& word)
{
    if (!word.empty() && std::all_of(word.begin(), word.end(), isPlain)) return word;
    std::string quoted = "'";
    for (const char c : word)
        if (c == '\'')
            quoted += "'\\''";
        else
            quoted += c;
    return quoted + "'";
}

std::vector<Command> commandsOf(const Job& job, const std::string& programs,
                                const std::string& output)
{
    const std::string folder = output + "/" + job.folder;
    std::vector<Command> commands{slamOf(job, programs, folder)};
    if (job.evaluate.empty()) return commands;
    Command evaluate{programs + "/mono-slam-eval"};
    evaluate.insert(evaluate.end(), job.evaluate.begin(), job.evaluate.end());
    evaluate.insert(evaluate.end(), {"--json", folder + "/" + kFiguresFile, folder});
    commands.push_back(evaluate);
    return commands;
}

Command checkOf(const Job& job, const std::string& programs, const std::string& output)
{
    Command command = slamOf(job, programs, output + "/" + job.folder);
    command.emplace_back("--dry-run");
    return command;
}

std::string shellLineOf(const Job& job, const std::string& programs, const std::string& output)
{
    auto commands = commandsOf(job, programs, output);
    commands.push_back({programs + "/mono-slam-batch", "--finish", output + "/" + job.folder});
    std::string line;
    for (const Command& command : commands)
    {
        if (!line.empty()) line += " && ";
        std::string words;
        for (const std::string& word : command)
            words += (words.empty() ? "" : " ") + shellWord(word);
        line += words;
    }
    return line;
}
}  // namespace monoslam
