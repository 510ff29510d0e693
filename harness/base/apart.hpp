// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/process.hpp"

namespace gloam::base {

// What the work itself threw; what() is its message.
class WorkError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The work came to no end: "takes more than 60 s", "takes more than 4096 MiB of memory", "ended by signal 11
// (SEGV: Segmentation fault)".
class LimitError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Calls `work` in a forked copy of this process and gives what it returned: whatever it does to memory, time
// or that process stays there. limits.memory_bytes is beyond what this process has already. Throws WorkError,
// LimitError, and std::system_error when no process can be had.
[[nodiscard]] std::string run_apart(const std::function<std::string()>& work, const ProcessLimits& limits);

// The same for many questions: one copy, made at the first of them, answers them in turn; one that comes to
// no end costs its question, and the next one goes to a new copy. The limits of time are those of each
// question. For one thread.
class Apart {
  public:
    using Work = std::function<std::string(std::string_view question)>;

    Apart(Work work, const ProcessLimits& limits);
    ~Apart();
    Apart(const Apart&) = delete;
    Apart& operator=(const Apart&) = delete;

    // Throws as run_apart().
    [[nodiscard]] std::string ask(std::string_view question);

  private:
    struct Copy;
    Work work_;
    ProcessLimits limits_;
    std::unique_ptr<Copy> copy_;
};

}  // namespace gloam::base
