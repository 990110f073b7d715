// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include <tclap/CmdLine.h>

#include <stdexcept>

namespace monoslam
{
Arguments parseArguments(int argc, char** argv)
{
    TCLAP::CmdLine cmd("kf-slam with joint data association, on kf-slam's own files", ' ',
                       MONOSLAM_VERSION);
    // One list: TCLAP knows no two optional unlabelled arguments.
    TCLAP::UnlabeledMultiArg<std::string> files(
        "files", "Options of kf-slam and the rawlog, instead of [MappingApplication] rawlog_file",
        true, "CONFIG.ini [RAWLOG]", cmd);
    TCLAP::ValueArg<std::string> output(
        "", "output", "Folder for all outputs, instead of logOutput_dir", false, "", "DIR", cmd);
    TCLAP::MultiArg<std::string> set("", "set", "Overrides one key of the ini", false,
                                     "section.key=value", cmd);
    TCLAP::ValueArg<unsigned> seed("", "seed", "Of the associations that MHDA draws", false, 1, "N",
                                   cmd);
    TCLAP::SwitchArg force("", "force", "Replace the files of an earlier run", cmd);
    cmd.parse(argc, argv);

    Arguments a;
    const std::vector<std::string>& names = files.getValue();
    if (names.size() > 2)
        throw std::invalid_argument("one CONFIG.ini and one RAWLOG at most; not " + names[2]);
    a.configFile = names[0];
    if (names.size() > 1) a.rawlog = names[1];
    a.output = output.getValue();
    a.settings = set.getValue();
    a.seed = seed.getValue();
    a.force = force.getValue();
    return a;
}
}  // namespace monoslam
