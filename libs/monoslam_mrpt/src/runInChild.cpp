// SPDX-License-Identifier: BSD-3-Clause
#include "runInChild.h"

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string>

#include "monoslam_support/ThreadClock.h"

namespace monoslam
{
namespace
{
/** So much longer on the clock than of CPU time, and a child is taken to wait for ever. */
constexpr double kClockPerCpu = 20.0;
constexpr int kFailed = 1;

[[noreturn]] void fail(const std::string& what)
{
    throw std::runtime_error("child process: " + what);
}

/** Whoever embeds the library may catch or block the signal, and a child inherits that. */
void endBy(int signal, __itimer_which timer, double after_ms)
{
    std::signal(signal, SIG_DFL);
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, signal);
    sigprocmask(SIG_UNBLOCK, &set, nullptr);
    const double whole_s = std::floor(1e-3 * after_ms);
    itimerval once{};
    once.it_value.tv_sec = static_cast<time_t>(whole_s);
    once.it_value.tv_usec = 1 + static_cast<suseconds_t>(1e6 * (1e-3 * after_ms - whole_s));
    setitimer(timer, &once, nullptr);
}

[[noreturn]] void beChild(double cap_ms, const std::function<void()>& compute, long& nanoseconds)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody waits for its answer any more
    endBy(SIGPROF, ITIMER_PROF, cap_ms);
    endBy(SIGALRM, ITIMER_REAL, kClockPerCpu * cap_ms);
    int status = 0;
    try
    {
        ThreadClock clock;
        compute();
        nanoseconds = std::lround(1e6 * clock.lap_ms());
    }
    catch (...)
    {
        status = kFailed;
    }
    _exit(status);  // no destructor of the parent's
}

double milliseconds(const timeval& t)
{
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
}
}  // namespace

SharedNumbers::SharedNumbers(std::size_t count) : count_(count)
{
    void* memory = mmap(nullptr, count * sizeof(long) + 1, PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) fail(std::string("no shared memory: ") + std::strerror(errno));
    numbers_ = static_cast<long*>(memory);
}

SharedNumbers::~SharedNumbers()
{
    munmap(numbers_, count_ * sizeof(long) + 1);
}

ChildRun runInChild(double cap_ms, const std::function<void()>& compute)
{
    SharedNumbers nanoseconds(1);
    const pid_t child = fork();
    if (child < 0) fail(std::string("cannot be made: ") + std::strerror(errno));
    if (child == 0) beChild(cap_ms, compute, nanoseconds[0]);
    int status = 0;
    rusage used{};
    while (wait4(child, &status, 0, &used) < 0)
        if (errno != EINTR) fail(std::string("cannot be waited for: ") + std::strerror(errno));
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
        return {true, 1e-6 * static_cast<double>(nanoseconds[0])};
    if (WIFEXITED(status)) fail("threw an exception");
    const int signal = WTERMSIG(status);
    if (signal != SIGPROF && signal != SIGALRM) fail("ended by signal " + std::to_string(signal));
    return {false, milliseconds(used.ru_utime) + milliseconds(used.ru_stime)};
}
}  // namespace monoslam
