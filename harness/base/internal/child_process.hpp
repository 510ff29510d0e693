// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>

#include "base/process.hpp"

namespace gloam::base::internal {

// A forked child that dies with this object, and with the thread that made it.
class ChildProcess {
  public:
    // `work` runs in the child, which must not return from it. Throws std::system_error that says what could
    // not be done: `what`.
    ChildProcess(const std::string& what, const std::function<void()>& work);
    ~ChildProcess();
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&&) = delete;
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    // Whether this process made it: a process that was forked later has a copy of this object, but not the
    // child.
    [[nodiscard]] bool is_ours() const;

    void kill() const;

    // Waits for its end; what waitpid() gives.
    int wait();

    [[nodiscard]] bool has_ended_by(std::chrono::steady_clock::time_point deadline) const;

  private:
    pid_t id_ = -1;
    pid_t parent_ = -1;
};

// The limits of memory and processor time, from now on. Allocates nothing.
void limit_this_process(const ProcessLimits& limits);

}  // namespace gloam::base::internal
