// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>

#include "run.h"

int main(int argc, char** argv)
{
    try
    {
        return monoslam::run(monoslam::parseArguments(argc, argv));
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "kf-slam-joint: %s\n", e.what());
        return 1;
    }
}
