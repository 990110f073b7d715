// SPDX-License-Identifier: BSD-3-Clause
#include <tclap/CmdLine.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "Figure.h"
#include "monoslam_mrpt/cameraFrom.h"

namespace
{
struct Arguments
{
    std::vector<std::string> runs;
    std::string groundtruth;
    std::string json;
    std::string depth;
    std::string camera;
    std::string perFrame;
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
    TCLAP::ValueArg<std::string> depth(
        "", "depth",
        "Landmark errors too: depth pictures NNNN.png (16 bit, z times 5000 per metre), "
        "NNNN the line of the true pose from 0",
        false, "", "FOLDER", cmd);
    TCLAP::ValueArg<std::string> camera("", "camera",
                                        "Of those pictures; camera.yaml beside their "
                                        "folder unless given",
                                        false, "", "FILE", cmd);
    std::vector<std::string> names{"none", "SE3", "Sim3"};
    TCLAP::ValuesConstraint<std::string> alignments(names);
    TCLAP::ValueArg<std::string> perFrame("", "per-frame",
                                          "Writes errors.csv to each run's folder, under this "
                                          "alignment",
                                          false, "", &alignments, cmd);
    TCLAP::SwitchArg csv("", "csv", "Prints CSV with all digits instead of the table", cmd);
    TCLAP::SwitchArg nearest("", "nearest", "Takes the nearest true pose instead of interpolating",
                             cmd);
    TCLAP::ValueArg<double> tolerance("", "tolerance", "To the nearest true pose [s]", false, 0.02,
                                      "S", cmd);
    TCLAP::UnlabeledMultiArg<std::string> runs(
        "output", "Output folders of mono-slam, or trajectories", true, "OUTPUT", cmd);
    cmd.parse(argc, argv);
    Arguments a;
    a.runs = runs.getValue();
    a.groundtruth = groundtruth.getValue();
    a.json = json.getValue();
    a.depth = depth.getValue();
    a.camera = camera.getValue();
    a.perFrame = perFrame.getValue();
    a.outAndBack = outAndBack.getValue();
    a.csv = csv.getValue();
    a.matching = {tolerance.getValue(), !nearest.getValue()};
    if (a.groundtruth.empty() != a.outAndBack)
        throw std::invalid_argument("give either --groundtruth FILE or --out-and-back");
    if (a.outAndBack && !(a.depth.empty() && a.perFrame.empty()))
        throw std::invalid_argument("--depth and --per-frame need --groundtruth");
    if (a.depth.empty() && !a.camera.empty()) throw std::invalid_argument("--camera needs --depth");
    return a;
}

std::optional<monoslam::LandmarkTruth> landmarkTruth(const Arguments& a,
                                                     const monoslam::Trajectory& truth)
{
    if (a.depth.empty()) return std::nullopt;
    const std::string camera =
        a.camera.empty()
            ? (std::filesystem::absolute(a.depth) / "../camera.yaml").lexically_normal().string()
            : a.camera;
    return monoslam::LandmarkTruth(truth, monoslam::readCameraFile(camera).camera, a.depth);
}

monoslam::Alignment alignmentOf(const std::string& name)
{
    if (name == "SE3") return monoslam::Alignment::SE3;
    return name == "Sim3" ? monoslam::Alignment::Sim3 : monoslam::Alignment::None;
}

std::vector<monoslam::Figure> figuresOf(const monoslam::RunOutput& run, const Arguments& arguments,
                                        const monoslam::Trajectory& truth,
                                        std::optional<monoslam::LandmarkTruth>& landmarks)
{
    if (arguments.outAndBack) return monoslam::figuresOutAndBack(run);
    const auto pairs = monoslam::matchByTime(run.trajectory, truth, arguments.matching);
    if (pairs.empty())
        std::cerr << "mono-slam-eval: " << run.name << ": no pose has a true one at its time\n";
    auto figures = monoslam::figuresAgainst(run, truth, arguments.matching);
    if (run.folder.empty() && (landmarks || !arguments.perFrame.empty()))
        throw std::invalid_argument(run.name +
                                    ": --depth and --per-frame need the folder of a run");
    if (landmarks)
        for (monoslam::Figure& figure : monoslam::landmarkFigures(run, pairs, *landmarks))
            figures.push_back(std::move(figure));
    if (!arguments.perFrame.empty())
        monoslam::writeErrors(run, pairs, alignmentOf(arguments.perFrame));
    return figures;
}

monoslam::Table evaluate(const Arguments& arguments)
{
    monoslam::Trajectory truth;
    if (!arguments.outAndBack) truth = monoslam::readTum(arguments.groundtruth);
    auto landmarks = landmarkTruth(arguments, truth);
    monoslam::Table table;
    for (const std::string& path : arguments.runs)
    {
        const monoslam::RunOutput run = monoslam::readRun(path);
        table.names.push_back(run.name);
        table.columns.push_back(figuresOf(run, arguments, truth, landmarks));
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
