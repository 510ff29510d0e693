// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>

namespace gloam::base {

/// Processor time that a process has used, all its threads together; zero for a process that has ended.
[[nodiscard]] std::chrono::nanoseconds processor_time_of(pid_t process);

/// Decides how long to wait for a process. A process that shares the machine with others may need far longer
/// than it would alone; one that waits for something that never comes uses no processor time. So a wait is
/// over once its limit has passed and the process has used that much processor time itself, or has used next
/// to none since the wait was last examined.
class Patience {
  public:
    using Clock = std::chrono::steady_clock;
    /// Processor time that the process has used so far.
    using Used = std::function<std::chrono::nanoseconds()>;

    /// The wait begins now. `limit`: positive.
    Patience(std::chrono::nanoseconds limit, Used used);

    /// When to call is_over() next.
    [[nodiscard]] Clock::time_point next_look() const { return next_; }

    /// Whether to give up. False before next_look(), and where the process should get more time: next_look()
    /// is later then.
    [[nodiscard]] bool is_over();

  private:
    std::chrono::nanoseconds limit_;
    Used used_;
    std::chrono::nanoseconds at_begin_;
    std::chrono::nanoseconds at_look_;  // processor time when the process was last looked at
    Clock::time_point looked_;
    Clock::time_point next_;
};

}  // namespace gloam::base
