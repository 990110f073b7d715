// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <future>
#include <vector>

#include "monoslam_support/ThreadClock.h"

namespace monoslam
{
/** work(0) ... work(count - 1) on at most \p threads threads, the calling one among them; an
 *  exception of any is thrown when all have ended. \return CPU time of the other threads [ms] */
inline double runInParallel(std::size_t count, int threads,
                            const std::function<void(std::size_t)>& work)
{
    const std::size_t workers = std::min(count, static_cast<std::size_t>(std::max(threads, 1)));
    const auto share = [&](std::size_t first)
    {
        ThreadClock clock;
        for (std::size_t i = first; i < count; i += workers) work(i);
        return clock.lap_ms();
    };
    std::vector<std::future<double>> others;
    for (std::size_t first = 1; first < workers; ++first)
        others.push_back(std::async(std::launch::async, share, first));
    share(0);
    double others_ms = 0.0;
    for (auto& other : others) others_ms += other.get();
    return others_ms;
}
}  // namespace monoslam
