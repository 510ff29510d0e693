// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/process.hpp"

namespace gloam::base {

// An exception of the work itself; what() is its message.
class WorkError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The work did not complete: "takes more than 60 s", "takes more than 4096 MiB of memory", "ended by signal
// 11 (SEGV: Segmentation fault)".
class LimitError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Calls `work` in a forked copy of this process and returns its result. Memory, time and crashes of the copy
// do not affect this process. limits.memory_bytes is added to what this process already uses. Throws
// WorkError, LimitError, and std::system_error if no process can be created.
[[nodiscard]] std::string run_apart(const std::function<std::string()>& work, const ProcessLimits& limits);

// The same for many questions: one copy, forked at the first question, answers them in turn. If it does not
// complete, that question fails and the next one goes to a new copy. Time limits are for each question. For
// one thread.
class Apart {
  public:
    using Work = std::function<std::string(std::string_view question)>;

    Apart(Work work, const ProcessLimits& limits);
    ~Apart();
    Apart(const Apart&) = delete;
    Apart& operator=(const Apart&) = delete;

    // Throws like run_apart().
    [[nodiscard]] std::string ask(std::string_view question);

  private:
    struct Copy;
    Work work_;
    ProcessLimits limits_;
    std::unique_ptr<Copy> copy_;
};

}  // namespace gloam::base
