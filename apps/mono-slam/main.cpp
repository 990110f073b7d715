// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>

#include "run.h"

int main(int argc, char** argv)
{
    const monoslam::Arguments arguments = monoslam::parseArguments(argc, argv);
    try
    {
        return monoslam::run(arguments);
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "mono-slam: %s\n", e.what());
        return 1;
    }
}
