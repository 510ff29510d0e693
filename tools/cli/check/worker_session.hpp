// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "check/answer.hpp"
#include "cli/worker_process.hpp"

namespace gloam::cli {

// What became of a question: the answer, or why there is none.
struct Reply {
    std::string line;
    check::Reason reason = check::Reason::none;
    std::string error;  // empty: there is an answer
};

// There is no worker to be had: twice in a row it came to nothing before it could greet, or its greeting was
// a refusal (Reason::error).
class NoWorker : public std::runtime_error {
  public:
    NoWorker(check::Reason why, const std::string& message) : std::runtime_error(message), reason(why) {}
    check::Reason reason;
};

// A worker that answers lines with lines, in a process of its own: one that crashes or stays silent costs
// the question that it was asked, and the next question goes to a new one. A worker greets with a line before
// it is asked anything. For use from one thread.
class WorkerSession {
  public:
    // `timeout`: longest wait for the greeting and for each answer; more where the worker computes and others
    // keep the processor from it (base::Patience). `refusal` says why a greeting is one;
    // empty for a welcome.
    WorkerSession(std::vector<std::string> command, std::chrono::milliseconds timeout,
                  std::function<std::string(const std::string& greeting)> refusal = {})
        : command_(std::move(command)), timeout_(timeout), refusal_(std::move(refusal)) {}

    // The greeting of the worker, which is started if there is none. Throws NoWorker.
    const std::string& greeting();

    // Asks one question. Throws NoWorker.
    [[nodiscard]] Reply ask(const std::string& question);

    // The next question goes to a new worker: this one's device is lost, say.
    void dismiss() { process_.reset(); }

  private:
    // The next line of the worker; without one it is dismissed and the reason told.
    Reply listen();

    std::vector<std::string> command_;
    std::chrono::milliseconds timeout_;
    std::function<std::string(const std::string&)> refusal_;
    std::optional<WorkerProcess> process_;
    std::string greeting_;
};

}  // namespace gloam::cli
