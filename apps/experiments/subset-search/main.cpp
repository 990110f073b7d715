// SPDX-License-Identifier: BSD-3-Clause
// How fast the largest jointly compatible subset is found and proved, and what a second test adds.
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "judgeSecondTests.h"
#include "timeSearches.h"

int main(int argc, char** argv)
{
    try
    {
        const std::string what = argc == 3 ? argv[1] : "";
        std::size_t read = 0;
        const int seeds = argc == 3 ? std::stoi(argv[2], &read) : 0;
        if ((what != "times" && what != "second-tests") || seeds < 1 ||
            read != std::string(argv[2]).size())
            throw std::invalid_argument("usage: times|second-tests SEEDS");
        if (what == "times")
            monoslam::timeSearches(static_cast<unsigned>(seeds));
        else
            monoslam::judgeSecondTests(static_cast<unsigned>(seeds));
        return 0;
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
        return 1;
    }
}
