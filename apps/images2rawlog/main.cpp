// SPDX-License-Identifier: BSD-3-Clause
#include <tclap/CmdLine.h>

#include <cstdio>
#include <exception>

#include "convert.h"

int main(int argc, char** argv)
{
    using monoslam::sourceFormats;
    TCLAP::CmdLine cmd("Converts an image sequence to an MRPT rawlog", ' ', MONOSLAM_VERSION);
    std::vector<std::string> formats = sourceFormats();
    TCLAP::ValuesConstraint<std::string> known(formats);
    TCLAP::ValueArg<std::string> format("", "format", "Layout of the input", true, "", &known, cmd);
    TCLAP::ValueArg<std::string> input("", "input", "Folder or video", true, "", "PATH", cmd);
    TCLAP::ValueArg<std::string> camera(
        "", "camera", "Calibration: camera.yaml, EuRoC's sensor.yaml or an MRPT ini", true, "",
        "FILE", cmd);
    TCLAP::ValueArg<std::string> truth("", "groundtruth", "Poses of the camera: TUM, EuRoC, KITTI",
                                       false, "", "FILE", cmd);
    TCLAP::ValueArg<double> fps_hz("", "fps", "Frames per second (folder, video)", false, 0, "F",
                                   cmd);
    TCLAP::SwitchArg embed("", "embed", "Store the images inside the rawlog", cmd);
    TCLAP::SwitchArg force("", "force", "Replace an existing rawlog", cmd);
    TCLAP::ValueArg<std::string> output("", "output", "The rawlog to write", true, "",
                                        "FILE.rawlog", cmd);
    cmd.parse(argc, argv);
    try
    {
        monoslam::convert({{format.getValue(), input.getValue(), fps_hz.getValue()},
                           camera.getValue(),
                           truth.getValue(),
                           output.getValue(),
                           embed.getValue(),
                           force.getValue()});
        return 0;
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "images2rawlog: %s\n", e.what());
        return 1;
    }
}
