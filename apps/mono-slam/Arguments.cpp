// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include <tclap/CmdLine.h>

namespace monoslam
{
Arguments parseArguments(int argc, char** argv)
{
    using Text = TCLAP::ValueArg<std::string>;
    TCLAP::CmdLine cmd("Path and map from a rawlog of one moving camera", ' ', MONOSLAM_VERSION);
    TCLAP::UnlabeledValueArg<std::string> config("config", "Options; see --write-default-config",
                                                 false, "", "CONFIG.ini", cmd);
    TCLAP::UnlabeledValueArg<std::string> rawlog("rawlog", "Instead of [rawlog] file", false, "",
                                                 "RAWLOG", cmd);
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
    cmd.parse(argc, argv);

    Arguments a;
    a.configFile = config.getValue();
    a.rawlog = rawlog.getValue();
    a.output = output.getValue();
    a.settings = set.getValue();
    a.robotPath = robotPath.getValue();
    a.defaultConfigFile = defaults.getValue();
    a.seed = seed.getValue();
    a.force = force.getValue();
    a.dryRun = dryRun.getValue();
    a.pictures = pictures.getValue();
    return a;
}
}  // namespace monoslam
