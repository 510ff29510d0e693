// SPDX-License-Identifier: MIT
#include "base/process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>

#include "base/file_descriptor.hpp"
#include "base/internal/child_process.hpp"

namespace gloam::base {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t last_bytes = 1000;  // of standard error

// The child's work between fork and exec, which neither allocates nor locks. Returns only if exec failed.
struct Program {
    char* const* arguments;
    int input;
    int output;
    int errors;
    const ProcessLimits& limits;

    void become() const {
        dup2(input, STDIN_FILENO);
        dup2(output, STDOUT_FILENO);
        dup2(errors, STDERR_FILENO);
        internal::limit_this_process(limits);
        execvp(arguments[0], arguments);
    }
};

// Starts a program as a child. Throws std::system_error if that fails.
internal::ChildProcess started(const std::vector<std::string>& command, int input, int output, int errors,
                               const ProcessLimits& limits) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    auto [failure, failure_end] =
        connected_pair();  // closed by a successful exec; otherwise carries its error
    const Program program{arguments.data(), input, output, errors, limits};
    internal::ChildProcess child("start " + words.at(0), [&, end = failure_end.get()] {
        program.become();
        const int error = errno;
        [[maybe_unused]] const ssize_t told = write(end, &error, sizeof error);
        _exit(127);
    });
    failure_end.reset();
    int error = 0;
    ssize_t count = 0;
    do count = read(failure.get(), &error, sizeof error);
    while (count < 0 && errno == EINTR);
    if (count != static_cast<ssize_t>(sizeof error)) return child;
    throw std::system_error(error, std::generic_category(), "cannot start " + words[0]);
}

// The parent's ends of a running program's three streams; each is closed when it has ended.
class Streams {
  public:
    Streams(FileDescriptor input, FileDescriptor output, FileDescriptor errors, std::string_view text)
        : files_{std::move(input), std::move(output), std::move(errors)}, text_(text) {}

    // Runs until both outputs have ended. Returns the limit that was exceeded, if any.
    ProcessResult::End exchange(const ProcessLimits& limits, Clock::time_point deadline,
                                ProcessResult& result) {
        while (files_[1].is_open() || files_[2].is_open()) {
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
            if (left <= 0) return ProcessResult::End::time;
            if (result.output.size() > limits.output_bytes) return ProcessResult::End::output;
            step(static_cast<int>(std::min<long long>(left, 1'000'000)), result);
        }
        return ProcessResult::End::status;
    }

  private:
    void step(int patience_ms, ProcessResult& result) {
        if (text_.empty()) files_[0].reset();
        std::array<pollfd, 3> waiting{};
        for (std::size_t i = 0; i < waiting.size(); ++i)
            waiting[i] = {.fd = files_[i].get(), .events = short(i == 0 ? POLLOUT : POLLIN), .revents = 0};
        if (poll(waiting.data(), waiting.size(), patience_ms) <= 0) return;
        if (waiting[0].revents != 0) send_some();
        if (waiting[1].revents != 0) receive_some(files_[1], result.output);
        if (waiting[2].revents != 0) receive_some(files_[2], result.errors);
        if (result.errors.size() > 2 * last_bytes) result.errors.erase(0, result.errors.size() - last_bytes);
    }

    void send_some() {
        const ssize_t count = send(files_[0].get(), text_.data(), text_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count > 0) text_.remove_prefix(static_cast<std::size_t>(count));
        if (count < 0 && errno != EINTR && errno != EAGAIN) text_ = {};  // it no longer listens
    }

    static void receive_some(FileDescriptor& file, std::string& text) {
        std::array<char, 65536> block{};
        const ssize_t count = recv(file.get(), block.data(), block.size(), MSG_DONTWAIT);
        if (count > 0) text.append(block.data(), static_cast<std::size_t>(count));
        if (count == 0 || (count < 0 && errno != EINTR && errno != EAGAIN)) file.reset();
    }

    std::array<FileDescriptor, 3> files_;
    std::string_view text_;
};

}  // namespace

std::string how_it_ended(int wait_status) {
    if (!WIFSIGNALED(wait_status)) return fmt::format("ended with status {}", WEXITSTATUS(wait_status));
    const int signal = WTERMSIG(wait_status);
    const char* name = sigabbrev_np(signal);
    const char* description = sigdescr_np(signal);
    return fmt::format("ended by signal {} ({}: {})", signal, name == nullptr ? "?" : name,
                       description == nullptr ? "?" : description);
}

std::string ProcessResult::how() const {
    std::string text;
    switch (end) {
        case End::status:
            text = fmt::format("ended with status {}", number);
            break;
        case End::signal:
            text = how_it_ended(number);
            break;
        case End::time:
            return "did not end in time";
        case End::output:
            return "does not stop writing";
    }
    return errors.empty() ? text : text + ": " + errors;
}

ProcessResult run_process(const std::vector<std::string>& command, std::string_view input,
                          const ProcessLimits& limits) {
    auto [to_child, child_input] = connected_pair();
    auto [from_child, child_output] = connected_pair();
    auto [errors, child_errors] = connected_pair();
    internal::ChildProcess child =
        started(command, child_input.get(), child_output.get(), child_errors.get(), limits);
    child_input.reset();
    child_output.reset();
    child_errors.reset();
    ProcessResult result;
    Streams streams(std::move(to_child), std::move(from_child), std::move(errors), input);
    const auto deadline = Clock::now() + limits.patience;
    ProcessResult::End exceeded = streams.exchange(limits, deadline, result);
    if (exceeded == ProcessResult::End::status && !child.has_ended_by(deadline))
        exceeded = ProcessResult::End::time;
    if (exceeded != ProcessResult::End::status) child.kill();
    const int status = child.wait();
    while (!result.errors.empty() && std::isspace(static_cast<unsigned char>(result.errors.back())) != 0)
        result.errors.pop_back();
    if (result.errors.size() > last_bytes) result.errors.erase(0, result.errors.size() - last_bytes);
    result.end = exceeded;
    if (exceeded != ProcessResult::End::status) return result;
    result.end = WIFSIGNALED(status) ? ProcessResult::End::signal : ProcessResult::End::status;
    result.number = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    return result;
}

}  // namespace gloam::base
