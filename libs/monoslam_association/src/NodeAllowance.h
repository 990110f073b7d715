// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace monoslam
{
/** What the searches of one problem may spend: work, in nodes of the prefix tree, and time. */
class NodeAllowance
{
   public:
    /** \param limit_ms  from now on; infinite: the clock is never read */
    NodeAllowance(long work, double limit_ms) : left_(work), timed_(limit_ms < kNever_ms)
    {
        if (timed_)
            deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                           std::chrono::duration<double, std::milli>(limit_ms));
    }

    /** At most \p work may be spent until the next call of this. */
    void openStage(long work)
    {
        last_ = work >= left_;
        stage_ = std::min(work, left_);
    }

    /** \return false if there is nothing left for this node */
    bool spend(long work)
    {
        if (stage_ < work || (timed_ && late(work)))
        {
            stage_ = 0;
            if (last_) left_ = 0;  // a rest too small for this node must not feed another stage
            return false;
        }
        stage_ -= work;
        left_ -= work;
        return true;
    }
    [[nodiscard]] long left() const { return left_; }

   private:
    using Clock = std::chrono::steady_clock;
    static constexpr double kNever_ms = std::numeric_limits<double>::infinity();
    /** Work between two looks at the clock. */
    static constexpr long kLook = 256;

    bool late(long work)
    {
        if ((sinceLook_ += work) < kLook) return false;
        sinceLook_ = 0;
        if (Clock::now() < deadline_) return false;
        last_ = true;
        return true;
    }

    long left_, stage_ = 0, sinceLook_ = 0;
    bool timed_, last_ = false;
    Clock::time_point deadline_;
};
}  // namespace monoslam
