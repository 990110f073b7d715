// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>
#include <utility>

namespace monoslam
{
/** CPU time of the calling thread, lap by lap: other processes do not count. */
class ThreadClock
{
   public:
    /** Time since the last lap, at first since construction [ms]. */
    double lap_ms()
    {
        const double now = read_ms();
        return now - std::exchange(last_ms_, now);
    }

   private:
    static double read_ms()
    {
        std::timespec t{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
        return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
    }
    double last_ms_ = read_ms();
};
}  // namespace monoslam
