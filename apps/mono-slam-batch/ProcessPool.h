// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "commands.h"

namespace monoslam
{
/** Programs that run one after the other, as long as each ends with status 0. */
struct Task
{
    std::size_t id = 0;
    std::vector<Command> commands;
    std::string log;  ///< what they print; its folder exists
};

struct TaskEnd
{
    std::size_t id = 0;
    int status = 0;  ///< of the last program that ran; 128 + signal, as in a shell
    double wall_s = 0.0;
};

/** Tasks side by side, each in processes of its own that end with the pool, and with this program
 *  even if that is killed. Ctrl-C on the terminal does not reach them. To be used by one thread. */
class ProcessPool
{
   public:
    explicit ProcessPool(std::size_t slots);
    ~ProcessPool();
    ProcessPool(const ProcessPool&) = delete;
    ProcessPool& operator=(const ProcessPool&) = delete;

    [[nodiscard]] bool isFull() const;
    [[nodiscard]] std::size_t running() const;

    /** \throw std::runtime_error naming a program that cannot be started, or the log */
    void start(Task task);

    /** Starts next programs and returns the tasks that have ended; does not wait. */
    [[nodiscard]] std::vector<TaskEnd> poll();

   private:
    struct Running;
    std::size_t slots_;
    std::vector<std::unique_ptr<Running>> running_;
};

/** Runs all tasks, and ends early, with all processes, when a signal comes.
 *  \param onPoll  called several times a second with what has ended, and how many run */
void runTasks(std::vector<Task> tasks, std::size_t slots,
              const std::function<void(const std::vector<TaskEnd>&, std::size_t)>& onPoll);
}  // namespace monoslam
