// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace monoslam
{
/** One line on a terminal's stderr that is rewritten; silent elsewhere. */
class Progress
{
   public:
    explicit Progress(long total);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void show(long done, const std::string& state);

   private:
    using Clock = std::chrono::steady_clock;

    long total_;
    bool onTerminal_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_{};
};
}  // namespace monoslam
