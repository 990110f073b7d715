// SPDX-License-Identifier: BSD-3-Clause
#include "runInChild.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace monoslam::test
{
namespace
{
void computeForEver()
{
    for (std::atomic<long> i{0};; ++i)
    {
    }
}
}  // namespace

TEST(RunInChild, BringsBackWhatTheChildWrote)
{
    SharedNumbers numbers(3);
    long own = 1;
    const ChildRun run = runInChild(1e4,
                                    [&]
                                    {
                                        for (std::size_t i = 0; i < numbers.size(); ++i)
                                            numbers[i] += 10 + static_cast<long>(i);
                                        own = 2;
                                    });
    EXPECT_TRUE(run.finished);
    EXPECT_EQ(numbers[0], 10);
    EXPECT_EQ(numbers[2], 12);
    EXPECT_EQ(own, 1);
    EXPECT_GE(run.cpu_ms, 0.0);
}

TEST(RunInChild, EndsAChildWhoseTimeIsOverEvenIfTheSignalsAreCaughtAndBlocked)
{
    const auto before = std::signal(SIGPROF, SIG_IGN);
    sigset_t set, old;
    sigemptyset(&set);
    sigaddset(&set, SIGPROF);
    sigprocmask(SIG_BLOCK, &set, &old);
    const ChildRun run = runInChild(20.0, computeForEver);
    sigprocmask(SIG_SETMASK, &old, nullptr);
    std::signal(SIGPROF, before);
    EXPECT_FALSE(run.finished);
    EXPECT_GE(run.cpu_ms, 10.0);
    EXPECT_LT(run.cpu_ms, 200.0);
}

TEST(RunInChild, EndsAChildThatWaitsForEver)
{
    EXPECT_FALSE(runInChild(5.0, [] { pause(); }).finished);
}

TEST(RunInChild, DoesNotTakeAFaultForACap)
{
    const auto fails = [] { throw std::logic_error("wrong"); };
    EXPECT_THROW(static_cast<void>(runInChild(1e4, fails)), std::runtime_error);
    const auto dies = [] { std::raise(SIGKILL); };
    EXPECT_THROW(static_cast<void>(runInChild(1e4, dies)), std::runtime_error);
}
}  // namespace monoslam::test
