// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>

#include "base/process.hpp"

namespace gloam::base::internal {

// A forked child that is killed with this object, and when the thread that made it ends.
class ChildProcess {
  public:
    // `work` runs in the child and must not return. Throws std::system_error with `what`, the name of the
    // failed action.
    ChildProcess(const std::string& what, const std::function<void()>& work);
    ~ChildProcess();
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&&) = delete;
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    // Whether this process made it. A process that was forked later has a copy of this object, but not the
    // child.
    [[nodiscard]] bool is_ours() const;

    void kill() const;

    // Waits for its end. Returns the status from waitpid().
    int wait();

    [[nodiscard]] bool has_ended_by(std::chrono::steady_clock::time_point deadline) const;

  private:
    pid_t id_ = -1;
    pid_t parent_ = -1;
};

// Applies the limits of memory and processor time to this process. Does not allocate.
void limit_this_process(const ProcessLimits& limits);

}  // namespace gloam::base::internal
