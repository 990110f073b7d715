// SPDX-License-Identifier: BSD-3-Clause
#include "ProcessPool.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/extend.hpp>
#include <boost/process/io.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "Interrupt.h"

namespace monoslam
{
namespace bp = boost::process;
using Clock = std::chrono::steady_clock;

namespace
{
constexpr auto kPollInterval = std::chrono::milliseconds(10);
constexpr int kSignalBase = 128;

/** Runs in the child before its program: it dies with its parent, and alone on Ctrl-C. */
void bindToParent(pid_t parent)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) std::_Exit(kSignalBase + SIGKILL);  // died before the line above
    setpgid(0, 0);
}

bp::child spawn(const Command& command, const std::string& log, bool append)
{
    std::FILE* file = std::fopen(log.c_str(), append ? "ae" : "we");
    if (file == nullptr) throw std::runtime_error(log + ": cannot be written");
    const pid_t parent = getpid();
    std::error_code failed;
    bp::child child(
        bp::exe = command.front(), bp::args = Command(command.begin() + 1, command.end()),
        (bp::std_out & bp::std_err) > file, bp::std_in < bp::null,
        bp::extend::on_exec_setup = [parent](auto&) { bindToParent(parent); }, failed);
    std::fclose(file);
    if (failed)
        throw std::runtime_error(command.front() + ": cannot be started: " + failed.message());
    return child;
}

int shellStatus(int status)
{
    return WIFEXITED(status) ? WEXITSTATUS(status) : kSignalBase + WTERMSIG(status);
}
}  // namespace

struct ProcessPool::Running
{
    Task task;
    std::size_t command = 0;
    Clock::time_point start = Clock::now();
    bp::child child;
};

ProcessPool::ProcessPool(std::size_t slots) : slots_(slots) {}

ProcessPool::~ProcessPool()
{
    std::error_code ignored;
    for (const auto& r : running_)
    {
        kill(-r->child.id(), SIGKILL);  // with what it has started itself
        r->child.terminate(ignored);
    }
}

bool ProcessPool::isFull() const
{
    return running_.size() >= slots_;
}

std::size_t ProcessPool::running() const
{
    return running_.size();
}

void ProcessPool::start(Task task)
{
    auto running = std::make_unique<Running>();
    running->child = spawn(task.commands.front(), task.log, false);
    running->task = std::move(task);
    running_.push_back(std::move(running));
}

std::vector<TaskEnd> ProcessPool::poll()
{
    std::vector<TaskEnd> ended;
    for (auto r = running_.begin(); r != running_.end();)
    {
        Running& running = **r;
        const Task& task = running.task;
        std::error_code failed;
        const bool runs = running.child.running(failed);
        if (failed) throw std::runtime_error("waiting for a program: " + failed.message());
        const int status = runs ? 0 : shellStatus(running.child.native_exit_code());
        if (!runs && status == 0 && running.command + 1 < task.commands.size())
            running.child = spawn(task.commands[++running.command], task.log, true);
        else if (!runs)
        {
            const std::chrono::duration<double> wall = Clock::now() - running.start;
            ended.push_back({task.id, status, wall.count()});
            r = running_.erase(r);
            continue;
        }
        ++r;
    }
    return ended;
}

void runTasks(std::vector<Task> tasks, std::size_t slots,
              const std::function<void(const std::vector<TaskEnd>&, std::size_t)>& onPoll)
{
    ProcessPool pool(slots);
    auto next = tasks.begin();
    while (next != tasks.end() || pool.running() > 0)
    {
        while (next != tasks.end() && !pool.isFull()) pool.start(std::move(*next++));
        const auto ended = pool.poll();
        if (interruptSignal() != 0) return;  // what ended now may have been ended by it
        onPoll(ended, pool.running());
        if (ended.empty()) std::this_thread::sleep_for(kPollInterval);
    }
}
}  // namespace monoslam
