// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace monoslam
{
/** Whole numbers, 0 at first, that a child process writes and its parent reads. */
class SharedNumbers
{
   public:
    /** \throw std::runtime_error if there is no memory for them */
    explicit SharedNumbers(std::size_t count);
    ~SharedNumbers();
    SharedNumbers(const SharedNumbers&) = delete;
    SharedNumbers& operator=(const SharedNumbers&) = delete;

    [[nodiscard]] long& operator[](std::size_t i) { return numbers_[i]; }
    [[nodiscard]] std::size_t size() const { return count_; }

   private:
    long* numbers_ = nullptr;
    std::size_t count_;
};

struct ChildRun
{
    bool finished = false;  ///< false: its time was over
    double cpu_ms = 0.0;    ///< of compute(), without that of making the child
};

/** Calls compute() in a child process, which the kernel ends when it has used \p cap_ms of CPU time,
 *  or twenty times as much has passed on the clock. Nothing that compute() changes is seen by the
 *  caller but SharedNumbers, which are whole only if it finished.
 *
 * For code that cannot be told to stop. It must start no threads, and may not wait for other ones:
 * they do not exist in the child.
 * \throw std::runtime_error if there is no child, or if it failed before its time was over */
[[nodiscard]] ChildRun runInChild(double cap_ms, const std::function<void()>& compute);
}  // namespace monoslam
