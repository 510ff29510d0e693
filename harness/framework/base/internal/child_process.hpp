// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/process.hpp"

namespace gloam::base::internal {

using Clock = std::chrono::steady_clock;

// A process inside a hung driver may be beyond any signal.
inline constexpr std::chrono::seconds time_to_die{10};

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

    void kill() const;

    // Waits for its end. Returns the status from waitpid().
    int wait();

    [[nodiscard]] bool has_ended_by(Clock::time_point deadline) const;

    [[nodiscard]] pid_t id() const { return id_; }

  private:
    pid_t id_ = -1;
    pid_t parent_ = -1;  // a process that was forked later has a copy of this object, but not the child
};

// Starts a program with these standard streams. command[0]: a path, or a name to find in PATH. Throws
// std::system_error if that fails.
[[nodiscard]] ChildProcess started(const std::vector<std::string>& command, std::array<int, 3> streams,
                                   const ProcessLimits* limits = nullptr);

// Sends all bytes to a connected process. Returns false if it cannot receive them.
[[nodiscard]] bool send_all(int connection, std::string_view bytes);

// Appends what the other end of a connection sends next, at most that many bytes.
enum class Arrival { bytes, end, silence };
[[nodiscard]] Arrival receive_some(int connection, Clock::time_point deadline, std::size_t most,
                                   std::string& text);

// Applies the limits of memory and processor time to this process. Does not allocate.
void limit_this_process(const ProcessLimits& limits);

}  // namespace gloam::base::internal
