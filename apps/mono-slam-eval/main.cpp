// SPDX-License-Identifier: BSD-3-Clause
#include <tclap/CmdLine.h>

#include <exception>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "Figure.h"

namespace
{
struct Arguments
{
    std::vector<std::string> runs;
    std::string groundtruth;
    std::string json;
    bool outAndBack = false;
    bool csv = false;
    monoslam::TimeMatchingOptions matching;
};

Arguments parse(int argc, char** argv)
{
    TCLAP::CmdLine cmd("Accuracy, consistency and time of mono-slam runs, side by side.", ' ',
                       "0.1");
    TCLAP::ValueArg<std::string> groundtruth(
        "g", "groundtruth", "True poses, 't x y z qx qy qz qw' a line", false, "", "FILE", cmd);
    TCLAP::SwitchArg outAndBack("", "out-and-back",
                                "No truth: the path goes out on a line and comes back", cmd);
    TCLAP::ValueArg<std::string> json("", "json", "Writes all figures to FILE", false, "", "FILE",
                                      cmd);
    TCLAP::SwitchArg csv("", "csv", "Prints CSV with all digits instead of the table", cmd);
    TCLAP::SwitchArg nearest("", "nearest", "Takes the nearest true pose instead of interpolating",
                             cmd);
    TCLAP::ValueArg<double> tolerance("", "tolerance", "To the nearest true pose [s]", false, 0.02,
                                      "S", cmd);
    TCLAP::UnlabeledMultiArg<std::string> runs(
        "output", "Output folders of mono-slam, or trajectories", true, "OUTPUT", cmd);
    cmd.parse(argc, argv);
    Arguments a{runs.getValue(), groundtruth.getValue(),
                json.getValue(), outAndBack.getValue(),
                csv.getValue(),  {tolerance.getValue(), !nearest.getValue()}};
    if (a.groundtruth.empty() != a.outAndBack)
        throw std::invalid_argument("give either --groundtruth FILE or --out-and-back");
    return a;
}

monoslam::Table evaluate(const Arguments& arguments)
{
    monoslam::Trajectory truth;
    if (!arguments.outAndBack) truth = monoslam::readTum(arguments.groundtruth);
    monoslam::Table table;
    for (const std::string& path : arguments.runs)
    {
        const monoslam::RunOutput run = monoslam::readRun(path);
        table.names.push_back(run.name);
        if (arguments.outAndBack)
        {
            table.columns.push_back(monoslam::figuresOutAndBack(run));
            continue;
        }
        if (monoslam::matchByTime(run.trajectory, truth, arguments.matching).empty())
            std::cerr << "mono-slam-eval: " << path << ": no pose has a true one at its time\n";
        table.columns.push_back(monoslam::figuresAgainst(run, truth, arguments.matching));
    }
    return table;
}
}  // namespace

int main(int argc, char** argv)
try
{
    const Arguments arguments = parse(argc, argv);
    const monoslam::Table table = evaluate(arguments);
    if (arguments.csv)
        monoslam::printCsv(std::cout, table);
    else
        monoslam::printTable(std::cout, table);
    if (arguments.json.empty()) return 0;
    std::ofstream file(arguments.json);
    monoslam::printJson(file, table);
    file.close();
    if (!file) throw std::runtime_error(arguments.json + ": cannot be written");
    return 0;
}
catch (const std::exception& e)
{
    std::cerr << "mono-slam-eval: " << e.what() << '\n';
    return 1;
}
