// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include <tclap/CmdLine.h>

namespace monoslam
{
Arguments parseArguments(int argc, char** argv)
{
    using Text = TCLAP::ValueArg<std::string>;
    TCLAP::CmdLine cmd(
        "Writes what a simulated camera sees, as pixels without images, to a rawlog with its "
        "truth; "
        "or runs an association strategy on such a rawlog",
        ' ', MONOSLAM_VERSION);
    TCLAP::UnlabeledValueArg<std::string> config("config", "Options, see --write-default-config",
                                                 false, "", "CONFIG.ini", cmd);
    Text output(
        "", "output",
        "FILE.rawlog to write, beside it FILE.tum with the true path; with --run the folder "
        "for the results",
        false, "", "FILE.rawlog|DIR", cmd);
    Text run("", "run", "Run [association] strategy on this rawlog instead", false, "",
             "FILE.rawlog", cmd);
    TCLAP::MultiArg<std::string> set("", "set", "Overrides one key of the ini", false,
                                     "section.key=value", cmd);
    TCLAP::ValueArg<unsigned> seed("", "seed", "Of all random numbers", false, 1, "N", cmd);
    TCLAP::SwitchArg force("", "force", "Replace the files of an earlier run", cmd);
    Text defaults("", "write-default-config", "Write the default options and end", false, "",
                  "FILE", cmd);
    cmd.parse(argc, argv);

    Arguments a;
    a.configFile = config.getValue();
    a.output = output.getValue();
    a.run = run.getValue();
    a.settings = set.getValue();
    a.defaultConfigFile = defaults.getValue();
    a.seed = seed.getValue();
    a.force = force.getValue();
    return a;
}
}  // namespace monoslam
