// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>

#include "run.h"

int main(int argc, char** argv)
{
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);  // so that an error comes after what went before
    try
    {
        monoslam::run(monoslam::parseArguments(argc, argv));
        return 0;
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "mono-slam-sim: %s\n", e.what());
        return 1;
    }
}
