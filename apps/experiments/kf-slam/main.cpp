// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>

#include "copyWithClutter.h"

namespace monoslam
{
namespace
{
Clutter clutterOf(const std::string& name)
{
    const std::map<std::string, Clutter> known{
        {"uniform", Clutter::Uniform}, {"echo", Clutter::Echo}, {"displaced", Clutter::Displaced}};
    const auto entry = known.find(name);
    if (entry == known.end())
        throw std::invalid_argument("clutter '" + name + "': uniform, echo or displaced");
    return entry->second;
}
}  // namespace
}  // namespace monoslam

int main(int argc, char** argv)
{
    try
    {
        if (argc != 6)
            throw std::invalid_argument(
                "expected: IN.rawlog OUT.rawlog uniform|echo|displaced MEAN_A_FRAME SEED");
        monoslam::copyWithClutter(argv[1], argv[2], monoslam::clutterOf(argv[3]),
                                  std::stod(argv[4]), static_cast<unsigned>(std::stoul(argv[5])));
        return 0;
    }
    catch (const std::exception& e)
    {
        std::fprintf(stderr, "experiment-kf-slam: %s\n", e.what());
        return 1;
    }
}
