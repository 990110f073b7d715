// SPDX-License-Identifier: BSD-3-Clause
#include "ProblemDump.h"

#include <algorithm>
#include <cstdio>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "monoslam_association/recordedFrameFile.h"
#include "monoslam_slam/writers.h"

namespace monoslam
{
namespace
{
std::pair<long, long> rangeOf(const std::string& text)
{
    static const std::regex range("([0-9]{1,9})(-([0-9]{1,9}))?");
    std::smatch parts;
    if (!std::regex_match(text, parts, range))
        throw std::invalid_argument("--dump-frames: " + text +
                                    ": expected frames such as 7 or 100-120, separated by commas");
    const long first = std::stol(parts[1].str());
    const long last = parts[3].matched ? std::stol(parts[3].str()) : first;
    if (last < first)
        throw std::invalid_argument("--dump-frames: " + text + ": ends before it begins");
    return {first, last};
}
}  // namespace

ProblemDump::ProblemDump(std::string folder, const std::string& frames, bool force)
    : folder_(std::move(folder)), force_(force)
{
    if (folder_.empty() && !frames.empty())
        throw std::invalid_argument("--dump-frames: nothing is written without --dump-association");
    std::istringstream list(frames);
    for (std::string range; std::getline(list, range, ',');) frames_.push_back(rangeOf(range));
    if (!folder_.empty()) checkOutputFolder(folder_, force_);
}

bool ProblemDump::chosen(long frame) const
{
    return frames_.empty() || std::any_of(frames_.begin(), frames_.end(),
                                          [frame](const std::pair<long, long>& range) {
                                              return frame >= range.first && frame <= range.second;
                                          });
}

void ProblemDump::attachTo(MonoSlam& slam)
{
    if (folder_.empty()) return;
    prepareOutputFolder(folder_, force_);
    slam.observeProblems(
        [this](long frame, const std::function<RecordedFrame()>& problem)
        {
            if (!chosen(frame)) return;
            char name[40];
            std::snprintf(name, sizeof name, "/association_%06ld.json", frame);
            OutputFile(folder_ + name).write(toText(problem()));
        });
}
}  // namespace monoslam
