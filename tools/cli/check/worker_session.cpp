// SPDX-License-Identifier: MIT
#include "cli/check/worker_session.hpp"

#include <fmt/format.h>

#include "base/patience.hpp"

namespace gloam::cli {
namespace {

constexpr int attempts = 2;

}  // namespace

const std::string& WorkerSession::greeting() {
    if (process_) return greeting_;
    Answer answer;
    for (int attempt = 0; attempt < attempts && !process_; ++attempt) {
        process_.emplace(command_);
        answer = listen();
    }
    if (!process_) throw NoWorker(answer.reason, answer.error);
    const std::string refusal = refusal_ ? refusal_(answer.line) : "";
    if (!refusal.empty()) {
        dismiss();
        throw NoWorker(report::Reason::error, refusal);
    }
    greeting_ = answer.line;
    return greeting_;
}

Answer WorkerSession::ask(const std::string& question) {
    greeting();
    process_->send(question);  // a worker that no longer listens has ended, as will be heard
    return listen();
}

Answer WorkerSession::listen() {
    Answer answer;
    base::Patience patience(timeout_, [this] { return base::processor_time_of(process_->id()); });
    auto heard = process_->receive(answer.line, patience.next_look());
    while (heard == WorkerProcess::Heard::silence && !patience.is_over())
        heard = process_->receive(answer.line, patience.next_look());
    switch (heard) {
        case WorkerProcess::Heard::line:
            return answer;
        case WorkerProcess::Heard::end:
            answer = {.line = {}, .reason = report::Reason::crash, .error = "the process " + process_->end()};
            break;
        case WorkerProcess::Heard::silence:
            answer = {.line = {},
                      .reason = report::Reason::hang,
                      .error = fmt::format("not finished after {:g} s, the time limit",
                                           std::chrono::duration<double>(timeout_).count())};
            break;
    }
    process_.reset();
    return answer;
}

}  // namespace gloam::cli
