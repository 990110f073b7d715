// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>

#include "gridTables.h"
#include "monoslam_mrpt/registerMrptAssociators.h"
#include "monoslam_slam/writers.h"
#include "solveFiles.h"

namespace monoslam
{
namespace
{
void checkFree(const std::string& file, bool force)
{
    if (!file.empty() && file != "/dev/stdout" && std::ifstream(file) && !force)
        throw std::runtime_error(file + ": exists; use --force to replace it");
}

void benchSynthetic(const Arguments& arguments, const Strategies& strategies)
{
    checkFree(arguments.csv, arguments.force);
    checkFree(arguments.output, arguments.force);
    const std::vector<Cell> cells = runGrid(arguments, strategies);
    const std::string tables = tablesOf(cells, strategies.names());
    std::printf("%s", tables.c_str());
    if (!arguments.csv.empty()) OutputFile(arguments.csv).write(csvOf(cells, strategies.names()));
    if (!arguments.output.empty()) OutputFile(arguments.output).write(tables);
}

void benchFiles(const Arguments& arguments, const Strategies& strategies)
{
    checkFree(arguments.csv, arguments.force);
    const std::string csv = solveFiles(arguments, strategies);
    if (!arguments.csv.empty()) OutputFile(arguments.csv).write(csv);
}

int run(const Arguments& arguments)
{
    registerMrptAssociators();
    const Strategies strategies(arguments);
    if (arguments.synthetic)
        benchSynthetic(arguments, strategies);
    else
        benchFiles(arguments, strategies);
    return 0;
}
}  // namespace
}  // namespace monoslam

int main(int argc, char** argv)
{
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // so that an error comes after what went before
    try
    {
        return monoslam::run(monoslam::parseArguments(argc, argv));
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "association-bench: %s\n", e.what());
        return 1;
    }
}
