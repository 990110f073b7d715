// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace monoslam
{
/** The cells of the synthetic grid: every combination of which no more than half is absent. */
struct GridAxes
{
    std::vector<int> landmarks{6, 12, 25, 50, 100};
    std::vector<int> candidates{1, 2, 3, 4};
    std::vector<int> absent{0, 1, 2, 5, 10};
    int problems = 100;  ///< in a cell
};

/** What the command line says; empty where it says nothing. */
struct Arguments
{
    std::vector<std::string> files;
    std::vector<std::string> strategies;  ///< empty: all
    std::string configFile;
    std::vector<std::string> settings;  ///< "association.NAME.key=value"
    bool synthetic = false;
    GridAxes grid;
    int workers = 2;
    unsigned seed = 1;
    std::string csv;
    std::string output;
    bool force = false;
};

/** Ends the program on --help, --version and on a wrong command line.
 *  \throw std::invalid_argument naming the option and what is wrong with it */
[[nodiscard]] Arguments parseArguments(int argc, char** argv);
}  // namespace monoslam
