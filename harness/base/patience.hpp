// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>

namespace gloam::base {

// Processor time that a process has used, over all its threads; zero for a process that has ended.
[[nodiscard]] std::chrono::nanoseconds processor_time_of(pid_t process);

// Decides how long to wait for a process. A process that shares the machine can need far longer than alone,
// but a process that waits for an event that never comes uses no processor time. So a wait ends after its
// limit, if the process has used that much processor time itself, or next to none since the last look.
class Patience {
  public:
    using Clock = std::chrono::steady_clock;
    // Returns the processor time that the process has used so far.
    using Used = std::function<std::chrono::nanoseconds()>;

    // Starts the wait. `limit`: positive.
    Patience(std::chrono::nanoseconds limit, Used used);

    // Time of the next call of is_over().
    [[nodiscard]] Clock::time_point next_look() const { return next_; }

    // Whether the wait is over. False before next_look(), and if the process gets more time; then next_look()
    // is later.
    [[nodiscard]] bool is_over();

  private:
    std::chrono::nanoseconds limit_;
    Used used_;
    std::chrono::nanoseconds at_begin_;
    std::chrono::nanoseconds at_look_;  // processor time at the last look
    Clock::time_point looked_;
    Clock::time_point next_;
};

}  // namespace gloam::base
