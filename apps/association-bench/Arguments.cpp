// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include <tclap/CmdLine.h>

#include <regex>
#include <sstream>
#include <stdexcept>

namespace monoslam
{
namespace
{
using Text = TCLAP::ValueArg<std::string>;

std::vector<std::string> split(const std::string& list)
{
    std::vector<std::string> items;
    std::istringstream stream(list);
    for (std::string item; std::getline(stream, item, ',');) items.push_back(item);
    return items;
}

/** Replaces \p values where the option is given. */
void readNumbers(const Text& option, int lowest, std::vector<int>& values)
{
    if (!option.isSet()) return;
    static const std::regex number("[0-9]{1,4}");
    values.clear();
    for (const std::string& item : split(option.getValue()))
    {
        if (!std::regex_match(item, number) || std::stoi(item) < lowest)
            throw std::invalid_argument("--" + option.getName() + " " + option.getValue() +
                                        ": expected whole numbers from " + std::to_string(lowest) +
                                        ", separated by commas");
        values.push_back(std::stoi(item));
    }
    if (values.empty()) throw std::invalid_argument("--" + option.getName() + ": is empty");
}

void check(const Arguments& a)
{
    if (a.synthetic == !a.files.empty())
        throw std::invalid_argument("either FILE... or --synthetic; see --help");
    if (!a.synthetic && !a.output.empty())
        throw std::invalid_argument("--output is of --synthetic");
    if (a.grid.problems < 1) throw std::invalid_argument("--problems: must be at least 1");
    if (a.workers < 1) throw std::invalid_argument("--workers: must be at least 1");
}
}  // namespace

Arguments parseArguments(int argc, char** argv)
{
    TCLAP::CmdLine cmd("Solves association problems with every strategy", ' ', MONOSLAM_VERSION);
    TCLAP::UnlabeledMultiArg<std::string> files(
        "files", "Problems written by mono-slam --dump-association", false, "FILE", cmd);
    Text strategies("", "strategies", "Only these, separated by commas", false, "", "NAMES|all",
                    cmd);
    Text config("", "config", "An ini of mono-slam, of which [association...] is read", false, "",
                "FILE", cmd);
    TCLAP::MultiArg<std::string> set("", "set", "Overrides one key of [association...]", false,
                                     "association.NAME.key=value", cmd);
    TCLAP::SwitchArg synthetic("", "synthetic", "Draw the problems instead", cmd);
    Text landmarks("", "landmarks", "6,12,25,50,100 unless given", false, "", "N,...", cmd);
    Text candidates("", "candidates", "Of a landmark: 1,2,3,4 unless given", false, "", "N,...",
                    cmd);
    Text absent("", "absent", "Landmarks not there: 0,1,2,5,10 unless given", false, "", "N,...",
                cmd);
    TCLAP::ValueArg<int> problems("", "problems", "In each cell", false, 100, "N", cmd);
    TCLAP::ValueArg<int> workers("", "workers", "Threads, a cell each", false, 2, "N", cmd);
    TCLAP::ValueArg<unsigned> seed("", "seed", "Of all random numbers", false, 1, "N", cmd);
    Text csv("", "csv", "Write the figures of every cell, or of every FILE", false, "", "FILE",
             cmd);
    Text output("", "output", "Write the tables as Markdown", false, "", "FILE", cmd);
    TCLAP::SwitchArg force("", "force", "Replace the files of an earlier run", cmd);
    cmd.parse(argc, argv);

    Arguments a;
    a.files = files.getValue();
    if (strategies.getValue() != "all") a.strategies = split(strategies.getValue());
    a.configFile = config.getValue();
    a.settings = set.getValue();
    a.synthetic = synthetic.getValue();
    readNumbers(landmarks, 1, a.grid.landmarks);
    readNumbers(candidates, 1, a.grid.candidates);
    readNumbers(absent, 0, a.grid.absent);
    a.grid.problems = problems.getValue();
    a.workers = workers.getValue();
    a.seed = seed.getValue();
    a.csv = csv.getValue();
    a.output = output.getValue();
    a.force = force.getValue();
    check(a);
    return a;
}
}  // namespace monoslam
