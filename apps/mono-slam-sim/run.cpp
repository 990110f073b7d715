// SPDX-License-Identifier: BSD-3-Clause
#include "run.h"

#include <stdexcept>

#include "monoslam_mrpt/registerMrptAssociators.h"
#include "monoslam_slam/writers.h"

namespace monoslam
{
void run(const Arguments& arguments)
{
    if (!arguments.defaultConfigFile.empty())
    {
        writeTextFile(arguments.defaultConfigFile, defaultConfig(), arguments.force);
        return;
    }
    if (arguments.configFile.empty())
        throw std::invalid_argument("no CONFIG.ini is given; see --help");
    if (arguments.output.empty()) throw std::invalid_argument("no --output is given; see --help");
    registerMrptAssociators();
    const Config config = loadConfig(arguments);
    if (arguments.run.empty())
        writeSimulation(arguments, config);
    else
        runStrategy(arguments, config);
}
}  // namespace monoslam
