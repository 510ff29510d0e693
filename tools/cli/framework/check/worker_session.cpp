// SPDX-License-Identifier: MIT
#include "cli/framework/check/worker_session.hpp"

#include <fmt/format.h>

namespace gloam::cli {
namespace {

using base::WorkerProcess;

constexpr int attempts = 2;

}  // namespace

const std::string& WorkerSession::greeting() {
    if (process_) return greeting_;
    Reply reply;
    for (int attempt = 0; attempt < attempts && !process_; ++attempt) {
        process_.emplace(command_);
        reply = listen();
    }
    if (!process_) throw NoWorker(reply.reason, reply.error);
    const std::string refusal = refusal_ ? refusal_(reply.line) : "";
    if (!refusal.empty()) {
        dismiss();
        throw NoWorker(check::Reason::error, refusal);
    }
    greeting_ = reply.line;
    return greeting_;
}

Reply WorkerSession::ask(const std::string& question) {
    greeting();
    process_->send(question);  // a worker that cannot receive has ended, which listen() will find
    return listen();
}

Reply WorkerSession::listen() {
    Reply reply;
    base::Patience patience(timeout_, [this] { return base::processor_time_of(process_->id()); });
    auto heard = process_->receive(reply.line, patience.next_look());
    while (heard == WorkerProcess::Heard::silence && !patience.is_over())
        heard = process_->receive(reply.line, patience.next_look());
    switch (heard) {
        case WorkerProcess::Heard::line:
            return reply;
        case WorkerProcess::Heard::end:
            reply = {.line = {}, .reason = check::Reason::crash, .error = "the process " + process_->end()};
            break;
        case WorkerProcess::Heard::silence:
            reply = {.line = {},
                     .reason = check::Reason::hang,
                     .error = fmt::format("not finished after {:g} s, the time limit",
                                          std::chrono::duration<double>(timeout_).count())};
            break;
    }
    process_.reset();
    return reply;
}

}  // namespace gloam::cli
