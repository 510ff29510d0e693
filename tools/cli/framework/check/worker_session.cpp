// SPDX-License-Identifier: MIT
#include "cli/framework/check/worker_session.hpp"

#include <fmt/format.h>
#include <cstdlib>
#include <string_view>

#include "base/number.hpp"

namespace gloam::cli {
namespace {

using base::WorkerProcess;

constexpr const char* index_variable = "GTEST_SHARD_INDEX";
constexpr const char* count_variable = "GTEST_TOTAL_SHARDS";

Shard shard_of(std::string_view index, std::string_view count, const std::string& where) {
    const auto part = base::number_from<std::size_t>(index);
    const auto of = base::number_from<std::size_t>(count);
    if (part && of && *part < *of) return {.index = *part, .count = *of};
    throw std::invalid_argument(where + ": expected INDEX/COUNT with 0 <= INDEX < COUNT, found " +
                                std::string(index) + "/" + std::string(count));
}

}  // namespace

Shard shard_from(const std::string& text) {
    if (!text.empty()) {
        const std::size_t slash = text.find('/');
        const std::string_view all = text;
        if (slash == std::string::npos) return shard_of(all, "", "--shard");
        return shard_of(all.substr(0, slash), all.substr(slash + 1), "--shard");
    }
    const char* index = std::getenv(index_variable);
    const char* count = std::getenv(count_variable);
    if (index == nullptr && count == nullptr) return {};
    return shard_of(index == nullptr ? "" : index, count == nullptr ? "" : count,
                    std::string(index_variable) + " and " + count_variable);
}

namespace {

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
