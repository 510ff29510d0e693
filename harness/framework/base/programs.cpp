// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "base/files.hpp"
#include "base/internal/child_process.hpp"
#include "base/process.hpp"

namespace gloam::base {
namespace {

using internal::Arrival;
using internal::Clock;

constexpr std::chrono::seconds time_to_end_by_itself{1};  // after it closed its output
constexpr std::size_t longest_line = 1U << 28U;           // bytes; more is no answer

// An unnamed file, for a worker's standard error.
FileDescriptor scratch_file() {
    std::string name = (std::filesystem::temp_directory_path() / "gloam-XXXXXX").string();
    FileDescriptor file(mkostemp(name.data(), O_CLOEXEC | O_APPEND));
    if (!file.is_open()) throw std::system_error(errno, std::generic_category(), "cannot make " + name);
    unlink(name.c_str());
    return beyond_standard(std::move(file));
}

// Without trailing white space.
std::string trimmed(std::string text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
    return text;
}

constexpr std::size_t most_words = 1000;  // bytes

// The end of a file.
std::string last_words(const FileDescriptor& file) {
    const off_t size = std::max<off_t>(lseek(file.get(), 0, SEEK_END), 0);
    std::string text(std::min(static_cast<std::size_t>(size), most_words), '\0');
    const ssize_t count = pread(file.get(), text.data(), text.size(), size - static_cast<off_t>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    return trimmed(std::move(text));
}

// Waits for either stream, a second at most, and appends what is there to its text; -1 stands for one that
// ended.
void receive_both(std::array<pollfd, 2>& streams, Clock::time_point deadline,
                  const std::array<std::string*, 2>& texts) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (poll(streams.data(), streams.size(), static_cast<int>(std::clamp<long long>(left, 0, 1000))) <= 0)
        return;
    for (std::size_t i = 0; i < streams.size(); ++i)
        if (streams[i].revents != 0 &&
            internal::receive_some(streams[i].fd, Clock::now(), std::size_t{1} << 16U, *texts[i]) ==
                Arrival::end)
            streams[i].fd = -1;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const ProcessLimits& limits) {
    const FileDescriptor nothing = beyond_standard(FileDescriptor(open("/dev/null", O_RDONLY | O_CLOEXEC)));
    auto [from_output, output] = connected_pair();
    auto [from_errors, errors] = connected_pair();
    internal::ChildProcess child =
        internal::started(command, {nothing.get(), output.get(), errors.get()}, &limits);
    output.reset();
    errors.reset();
    ProcessResult result;
    const auto exceeds = [&] {
        return std::max(result.output.size(), result.errors.size()) > limits.output_bytes;
    };
    const auto deadline = Clock::now() + limits.patience;
    std::array<pollfd, 2> streams{{{from_output.get(), POLLIN, 0}, {from_errors.get(), POLLIN, 0}}};
    const auto are_open = [&] { return streams[0].fd >= 0 || streams[1].fd >= 0; };
    while (are_open() && Clock::now() < deadline && !exceeds())
        receive_both(streams, deadline, {&result.output, &result.errors});
    if (exceeds()) {
        result.end = ProcessResult::End::output;
    } else if (are_open() || !child.has_ended_by(deadline)) {
        result.end = ProcessResult::End::time;
    }
    if (result.end != ProcessResult::End::status) child.kill();
    if (limits.group) ::kill(-child.id(), SIGKILL);
    const int status = child.wait();
    if (result.errors.size() > most_words) result.errors.erase(0, result.errors.size() - most_words);
    result.errors = trimmed(std::move(result.errors));
    if (result.end != ProcessResult::End::status) return result;
    if (WIFSIGNALED(status)) result.end = ProcessResult::End::signal;
    result.number = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    return result;
}

struct WorkerProcess::Running {
    FileDescriptor connection;
    FileDescriptor errors;
    internal::ChildProcess child;
    pid_t id = child.id();
    std::optional<int> status{};  // from waitpid(), after it has ended
};

WorkerProcess::WorkerProcess(const std::vector<std::string>& command) : running_(nullptr, nullptr) {
    auto [ours, theirs] = connected_pair();
    FileDescriptor errors = scratch_file();
    internal::ChildProcess child = internal::started(command, {theirs.get(), theirs.get(), errors.get()});
    running_ = make_hidden<Running>(Running{std::move(ours), std::move(errors), std::move(child)});
}

pid_t WorkerProcess::id() const {
    return running_->id;
}

bool WorkerProcess::send(std::string_view line) {
    return internal::send_all(running_->connection.get(), std::string(line) + '\n');
}

WorkerProcess::Heard WorkerProcess::receive(std::string& line, Clock::time_point deadline) {
    std::size_t searched = 0;
    while (true) {
        const std::size_t end = heard_.find('\n', searched);
        if (end != std::string::npos || heard_.size() > longest_line) {
            line = heard_.substr(0, end);
            heard_.erase(0, end == std::string::npos ? end : end + 1);
            return Heard::line;
        }
        searched = heard_.size();
        const Arrival arrived =
            internal::receive_some(running_->connection.get(), deadline, longest_line, heard_);
        if (arrived != Arrival::bytes) return arrived == Arrival::end ? Heard::end : Heard::silence;
    }
}

std::string WorkerProcess::end() {
    internal::ChildProcess& child = running_->child;
    if (!running_->status) {
        if (!child.has_ended_by(Clock::now() + time_to_end_by_itself)) child.kill();
        if (!child.has_ended_by(Clock::now() + internal::time_to_die))
            return fmt::format("process {} does not even end when killed", running_->id);
        running_->status = child.wait();
    }
    const std::string text = how_it_ended(*running_->status);
    const std::string words = last_words(running_->errors);
    return words.empty() ? text : text + ": " + words;
}

}  // namespace gloam::base
