// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/process.hpp"
#include "judge/answer.hpp"

namespace gloam::cli {

// The result of a question: the answer, or why there is none.
struct Reply {
    std::string line;
    check::Reason reason = check::Reason::none;
    std::string error;  // empty: there is an answer
};

// No worker is available: twice in succession it failed before its greeting, or its greeting was a refusal
// (Reason::error).
class NoWorker : public std::runtime_error {
  public:
    NoWorker(check::Reason why, const std::string& message) : std::runtime_error(message), reason(why) {}
    check::Reason reason;
};

// A worker that answers lines with lines, in a process of its own. If it crashes or stays silent, that
// question fails and the next one goes to a new worker. A worker greets with a line before the first
// question. For one thread.
class WorkerSession {
  public:
    // `timeout`: longest wait for the greeting and for each answer; longer if the worker computes and others
    // use the processor (base::Patience). `refusal`: returns the reason if a greeting is a refusal, "" if
    // not.
    WorkerSession(std::vector<std::string> command, std::chrono::milliseconds timeout,
                  std::function<std::string(const std::string& greeting)> refusal = {})
        : command_(std::move(command)), timeout_(timeout), refusal_(std::move(refusal)) {}

    // The greeting of the worker; starts one if there is none. Throws NoWorker.
    const std::string& greeting();

    // Asks one question. Throws NoWorker.
    [[nodiscard]] Reply ask(const std::string& question);

    // Sends the next question to a new worker, for example because this one's device is lost.
    void dismiss() { process_.reset(); }

  private:
    // The next line of the worker. Without one the worker is dismissed, and the reply has the reason.
    Reply listen();

    std::vector<std::string> command_;
    std::chrono::milliseconds timeout_;
    std::function<std::string(const std::string&)> refusal_;
    std::optional<base::WorkerProcess> process_;
    std::string greeting_;
};

}  // namespace gloam::cli
