// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <algorithm>
#include <cctype>
#include <cerrno>
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

constexpr std::chrono::seconds time_to_end_by_itself{1};  // after it closed its output
constexpr std::size_t longest_line = 1U << 28U;           // bytes; more is no answer

FileDescriptor scratch_file() {
    std::string name = (std::filesystem::temp_directory_path() / "gloam-XXXXXX").string();
    FileDescriptor file(mkostemp(name.data(), O_CLOEXEC));
    if (!file.is_open()) throw std::system_error(errno, std::generic_category(), "cannot make " + name);
    unlink(name.c_str());
    return beyond_standard(std::move(file));
}

std::string last_words(const FileDescriptor& file) {
    constexpr auto most = static_cast<off_t>(internal::last_bytes);
    const off_t size = lseek(file.get(), 0, SEEK_END);
    std::string text(static_cast<std::size_t>(std::clamp<off_t>(size, 0, most)), '\0');
    const ssize_t count = pread(file.get(), text.data(), text.size(), std::max<off_t>(0, size - most));
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
    return text;
}

}  // namespace

struct WorkerProcess::Running {
    explicit Running(const std::vector<std::string>& command) : Running(command, connected_pair()) {}

    FileDescriptor connection;
    FileDescriptor errors = scratch_file();
    internal::ChildProcess child;
    pid_t id = child.id();
    std::optional<int> status{};  // from waitpid(), after it has ended

  private:
    Running(const std::vector<std::string>& command, std::pair<FileDescriptor, FileDescriptor> ends)
        : connection(std::move(ends.first)),
          child(internal::started(command, {ends.second.get(), ends.second.get(), errors.get()})) {}
};

WorkerProcess::WorkerProcess(const std::vector<std::string>& command)
    : running_(make_hidden<Running>(command)) {}

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
        switch (internal::receive_some(running_->connection.get(), deadline, longest_line, heard_)) {
            case internal::Arrival::bytes:
                break;
            case internal::Arrival::end:
                return Heard::end;
            case internal::Arrival::silence:
                return Heard::silence;
        }
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
