// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include <tclap/CmdLine.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace monoslam
{
Arguments parseArguments(int argc, char** argv)
{
    using Text = TCLAP::ValueArg<std::string>;
    TCLAP::CmdLine cmd("Path and map from a rawlog of one moving camera", ' ', MONOSLAM_VERSION);
    // One list: TCLAP knows no two optional unlabelled arguments.
    TCLAP::UnlabeledMultiArg<std::string> files(
        "files", "Options (see --write-default-config) and the rawlog, instead of [rawlog] file",
        false, "CONFIG.ini [RAWLOG]", cmd);
    Text output("", "output", "Folder for all outputs, instead of [output] directory", false, "",
                "DIR", cmd);
    TCLAP::MultiArg<std::string> set("", "set", "Overrides one key of the ini", false,
                                     "section.key=value", cmd);
    TCLAP::ValueArg<unsigned> seed("", "seed", "Of all random numbers", false, 1, "N", cmd);
    TCLAP::SwitchArg force("", "force", "Replace the files of an earlier run", cmd);
    TCLAP::SwitchArg dryRun("", "dry-run", "Check configuration, rawlog and output only", cmd);
    TCLAP::SwitchArg pictures("", "pictures", "Write a picture of every frame and a top view", cmd);
    Text robotPath("", "robot-path", "Also write the vehicle's path (TUM)", false, "", "FILE", cmd);
    Text defaults("", "write-default-config", "Write the default options and end", false, "",
                  "FILE", cmd);
    TCLAP::SwitchArg strategies("", "list-strategies", "Print what each strategy uses, and end",
                                cmd);
    Text dump("", "dump-association", "Also write the association problem of every frame", false,
              "", "DIR", cmd);
    Text dumpFrames("", "dump-frames", "Only those of these frames, such as 7,100-120", false, "",
                    "A-B,...", cmd);
    cmd.parse(argc, argv);

    Arguments a;
    const std::vector<std::string>& names = files.getValue();
    if (names.size() > 2)
        throw std::invalid_argument("one CONFIG.ini and one RAWLOG at most; not " + names[2]);
    if (!names.empty()) a.configFile = names[0];
    if (names.size() > 1) a.rawlog = names[1];
    a.output = output.getValue();
    a.settings = set.getValue();
    a.robotPath = robotPath.getValue();
    a.defaultConfigFile = defaults.getValue();
    a.dumpFolder = dump.getValue();
    a.dumpFrames = dumpFrames.getValue();
    a.listStrategies = strategies.getValue();
    a.seed = seed.getValue();
    a.force = force.getValue();
    a.dryRun = dryRun.getValue();
    a.pictures = pictures.getValue();
    return a;
}
}  // namespace monoslam
