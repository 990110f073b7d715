// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace monoslam
{
Progress::Progress(long total)
    : total_(std::max(total, 1L)), onTerminal_(isatty(STDERR_FILENO) != 0)
{
}

Progress::~Progress()
{
    if (onTerminal_) std::fputs("\r\033[K", stderr);
}

void Progress::show(long done, const std::string& state)
{
    const auto now = Clock::now();
    if (!onTerminal_ || (done < total_ && now - shown_ < std::chrono::milliseconds(100))) return;
    shown_ = now;
    const double elapsed_s = std::chrono::duration<double>(now - start_).count();
    const double left_s =
        elapsed_s * static_cast<double>(total_ - done) / static_cast<double>(std::max(done, 1L));
    const int width = 30;
    const int filled = static_cast<int>(width * done / total_);
    const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                            std::string(static_cast<std::size_t>(width - filled), '.');
    std::fprintf(stderr, "\r[%s] %ld/%ld  %s  ETA %d:%02d \033[K", bar.c_str(), done, total_,
                 state.c_str(), static_cast<int>(left_s) / 60, static_cast<int>(left_s) % 60);
}
}  // namespace monoslam
