// SPDX-License-Identifier: MIT
#include "cli/worker_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <thread>
#include <utility>

#include "base/process.hpp"

namespace gloam::cli {
namespace {

using namespace std::chrono_literals;
using base::FileDescriptor;

constexpr auto to_end_by_itself = 1s;            // time to end by itself after it closed its output
constexpr auto to_die = 10s;                     // a process inside a hung driver may be beyond any signal
constexpr std::size_t longest_line = 1U << 28U;  // bytes; more is no answer
constexpr off_t last_bytes = 1000;

[[noreturn]] void fail(int error, const std::string& what) {
    throw std::system_error(error, std::generic_category(), what);
}

FileDescriptor scratch_file() {
    std::string name = (std::filesystem::temp_directory_path() / "gloam-XXXXXX").string();
    FileDescriptor file(mkostemp(name.data(), O_CLOEXEC));
    if (file.get() < 0) fail(errno, "cannot make " + name);
    unlink(name.c_str());
    return base::beyond_standard(std::move(file));
}

// The child's work between fork and exec, which neither allocates nor locks. Returns only if exec failed.
void become(char* const* arguments, int connection, int errors, pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);  // the parent ended before this took effect
    dup2(connection, STDIN_FILENO);
    dup2(connection, STDOUT_FILENO);
    dup2(errors, STDERR_FILENO);
    execv(arguments[0], arguments);
}

}  // namespace

WorkerProcess::WorkerProcess(const std::vector<std::string>& command) : errors_(scratch_file()) {
    auto [ours, theirs] = base::connected_pair();
    connection_ = std::move(ours);
    start(command, theirs.get());
}

void WorkerProcess::start(const std::vector<std::string>& command, int theirs) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    auto [failure, failure_end] =
        base::connected_pair();  // closed by a successful exec; otherwise carries its error
    const pid_t parent = getpid();
    child_ = fork();
    if (child_ < 0) fail(errno, "cannot start " + command.at(0));
    if (child_ == 0) {
        become(arguments.data(), theirs, errors_.get(), parent);
        const int error = errno;
        [[maybe_unused]] const ssize_t told = write(failure_end.get(), &error, sizeof error);
        _exit(127);
    }
    running_ = true;
    failure_end.reset();
    int error = 0;
    ssize_t count = 0;
    do count = read(failure.get(), &error, sizeof error);
    while (count < 0 && errno == EINTR);
    if (count != static_cast<ssize_t>(sizeof error)) return;
    wait(to_die);
    fail(error, "cannot start " + command.at(0));
}

WorkerProcess::~WorkerProcess() {
    if (!running_) return;
    kill(child_, SIGKILL);
    wait(to_die);
}

bool WorkerProcess::send(std::string_view line) {
    std::string text(line);
    text += '\n';
    for (std::string_view rest = text; !rest.empty();) {
        const ssize_t count = ::send(connection_.get(), rest.data(), rest.size(), MSG_NOSIGNAL);
        if (count >= 0) {
            rest.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
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
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
        pollfd one{.fd = connection_.get(), .events = POLLIN, .revents = 0};
        const int ready = poll(&one, 1, static_cast<int>(std::clamp<long long>(left, 0, 1'000'000)));
        if (ready == 0 && Clock::now() >= deadline) return Heard::silence;
        if (ready <= 0) continue;  // interrupted
        std::array<char, 65536> block{};
        const ssize_t count = recv(connection_.get(), block.data(), block.size(), 0);
        if (count > 0) heard_.append(block.data(), static_cast<std::size_t>(count));
        if (count == 0 || (count < 0 && errno != EINTR)) return Heard::end;
    }
}

std::string WorkerProcess::end() {
    if (running_ && !wait(to_end_by_itself)) {
        kill(child_, SIGKILL);
        if (!wait(to_die)) return fmt::format("process {} does not even end when killed", child_);
    }
    const std::string text = base::how_it_ended(status_);
    const std::string words = last_words();
    return words.empty() ? text : text + ": " + words;
}

// Polls, because no wait with a time limit works in every thread.
bool WorkerProcess::wait(Clock::duration patience) {
    const auto deadline = Clock::now() + patience;
    while (running_) {
        const pid_t ended = waitpid(child_, &status_, WNOHANG);
        if (ended == child_ || (ended < 0 && errno != EINTR)) {
            running_ = false;
        } else if (Clock::now() >= deadline) {
            return false;
        } else {
            std::this_thread::sleep_for(1ms);
        }
    }
    return true;
}

std::string WorkerProcess::last_words() const {
    const off_t size = lseek(errors_.get(), 0, SEEK_END);
    std::string text(static_cast<std::size_t>(std::clamp<off_t>(size, 0, last_bytes)), '\0');
    const ssize_t count =
        pread(errors_.get(), text.data(), text.size(), std::max<off_t>(0, size - last_bytes));
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
    return text;
}

}  // namespace gloam::cli
