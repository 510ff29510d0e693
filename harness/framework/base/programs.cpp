// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
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
constexpr std::chrono::milliseconds between_looks{20};    // at how much a program has written
constexpr std::size_t longest_line = 1U << 28U;           // bytes; more is no answer

// An unnamed file, for standard error.
FileDescriptor scratch_file() {
    std::string name = (std::filesystem::temp_directory_path() / "gloam-XXXXXX").string();
    FileDescriptor file(mkostemp(name.data(), O_CLOEXEC | O_APPEND));
    if (!file.is_open()) throw std::system_error(errno, std::generic_category(), "cannot make " + name);
    unlink(name.c_str());
    return beyond_standard(std::move(file));
}

off_t size_of(const FileDescriptor& file) {
    return std::max<off_t>(lseek(file.get(), 0, SEEK_END), 0);
}

// The end of a file, without trailing white space.
std::string last_words(const FileDescriptor& file) {
    constexpr off_t most = 1000;  // bytes
    const off_t size = size_of(file);
    std::string text(static_cast<std::size_t>(std::min(size, most)), '\0');
    const ssize_t count = pread(file.get(), text.data(), text.size(), std::max<off_t>(0, size - most));
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
    return text;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const ProcessLimits& limits) {
    const FileDescriptor nothing = beyond_standard(FileDescriptor(open("/dev/null", O_RDONLY | O_CLOEXEC)));
    const FileDescriptor errors = scratch_file();
    auto [from_child, child_output] = connected_pair();
    internal::ChildProcess child =
        internal::started(command, {nothing.get(), child_output.get(), errors.get()}, &limits);
    child_output.reset();
    ProcessResult result;
    const auto exceeds = [&] {
        return std::max(result.output.size(), static_cast<std::size_t>(size_of(errors))) >
               limits.output_bytes;
    };
    const auto deadline = Clock::now() + limits.patience;
    Arrival arrived = Arrival::bytes;
    while (arrived != Arrival::end && Clock::now() < deadline && !exceeds())
        arrived = internal::receive_some(from_child.get(), std::min(deadline, Clock::now() + between_looks),
                                         std::size_t{1} << 16U, result.output);
    if (exceeds()) {
        result.end = ProcessResult::End::output;
    } else if (arrived != Arrival::end || !child.has_ended_by(deadline)) {
        result.end = ProcessResult::End::time;
    }
    if (result.end != ProcessResult::End::status) child.kill();
    if (limits.group) ::kill(-child.id(), SIGKILL);
    const int status = child.wait();
    result.errors = last_words(errors);
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
