// SPDX-License-Identifier: BSD-3-Clause
#include "runSeeds.h"

#include <atomic>
#include <exception>
#include <thread>

namespace monoslam
{
OutcomesOfSeeds runSeeds(const Method& method, const Disturbance& disturbance, unsigned seeds,
                         unsigned threads)
{
    OutcomesOfSeeds ofSeeds(seeds);
    std::atomic<unsigned> next{0};
    std::atomic<bool> failed{false};
    std::exception_ptr failure;
    const auto work = [&]
    {
        try
        {
            for (unsigned i = next++; i < seeds && !failed; i = next++)
                ofSeeds[i] = disturbedRuns(method, disturbance, i + 1);
        }
        catch (...)
        {
            if (!failed.exchange(true)) failure = std::current_exception();
        }
    };
    std::vector<std::thread> pool;
    for (unsigned i = 0; i < threads; ++i) pool.emplace_back(work);
    for (std::thread& thread : pool) thread.join();
    if (failure) std::rethrow_exception(failure);
    return ofSeeds;
}
}  // namespace monoslam
