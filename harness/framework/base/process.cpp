// SPDX-License-Identifier: MIT
#include "base/process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <system_error>
#include <thread>
#include <utility>

#include "base/files.hpp"
#include "base/internal/child_process.hpp"

namespace gloam::base {
namespace {

// A computing process gets at least this share of a core, even on a machine with many of them.
constexpr double least_share = 0.05;
constexpr std::chrono::milliseconds shortest_wait{10};

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
    if (end == End::time) return "did not end in time";
    if (end == End::output) return "does not stop writing";
    const std::string text =
        end == End::signal ? how_it_ended(number) : fmt::format("ended with status {}", number);
    return errors.empty() ? text : text + ": " + errors;
}

std::chrono::nanoseconds processor_time_of(pid_t process) {
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return {};
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

void wait_patiently(std::chrono::nanoseconds limit, const std::function<std::chrono::nanoseconds()>& used,
                    const std::function<bool(std::chrono::steady_clock::time_point until)>& done) {
    const std::chrono::nanoseconds at_begin = used();
    std::chrono::nanoseconds at_look = at_begin;
    auto looked = internal::Clock::now();
    for (auto next = looked + limit; !done(next);) {
        const auto now = internal::Clock::now();
        if (now < next) continue;
        const std::chrono::nanoseconds so_far = used();
        const std::chrono::duration<double> since_look = so_far - at_look;
        const std::chrono::duration<double> waited = now - looked;
        if (so_far - at_begin >= limit || since_look < least_share * waited) return;
        looked = now;
        at_look = so_far;
        next = now + std::max<std::chrono::nanoseconds>(limit - (so_far - at_begin), shortest_wait);
    }
}

}  // namespace gloam::base

namespace gloam::base::internal {
namespace {

// A sanitizer's shadow memory takes the whole address space.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool address_space_is_ours = false;
#elif defined(__has_feature)
constexpr bool address_space_is_ours = !__has_feature(address_sanitizer);
#else
constexpr bool address_space_is_ours = true;
#endif

// `more`: from the soft limit, which can be handled, to the hard limit.
void limit(__rlimit_resource resource, rlim_t value, rlim_t more = 0) {
    rlimit now{};
    if (getrlimit(resource, &now) != 0) return;
    const rlimit both{.rlim_cur = std::min(value, now.rlim_max),
                      .rlim_max = std::min(value + more, now.rlim_max)};
    setrlimit(resource, &both);
}

}  // namespace

ChildProcess::ChildProcess(const std::string& what, const std::function<void()>& work) {
    parent_ = getpid();
    id_ = fork();
    if (id_ < 0) throw std::system_error(errno, std::generic_category(), "cannot " + what);
    if (id_ != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent_) _exit(1);  // the parent ended before this took effect
    work();
    _exit(1);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : id_(std::exchange(other.id_, -1)), parent_(other.parent_) {}

ChildProcess::~ChildProcess() {
    if (id_ <= 0 || parent_ != getpid()) return;
    kill();
    if (has_ended_by(Clock::now() + time_to_die)) (void)wait();
}

void ChildProcess::kill() const {
    ::kill(id_, SIGKILL);
}

int ChildProcess::wait() {
    int status = 0;
    while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
    return status;
}

bool ChildProcess::has_ended_by(Clock::time_point deadline) const {
    siginfo_t info{};
    do {
        info.si_pid = 0;
        if (waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) != 0) return true;
        if (info.si_pid != 0) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    } while (Clock::now() < deadline);
    return false;
}

ChildProcess started(const std::vector<std::string>& command, std::array<int, 3> streams,
                     const ProcessLimits* limits) {
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::vector<std::string> more = limits == nullptr ? std::vector<std::string>{} : limits->environment;
    std::vector<char*> variables;
    for (std::string& variable : more) variables.push_back(variable.data());
    for (char** own = environ; *own != nullptr; ++own) {
        const std::string_view one(*own);
        const std::string_view name = one.substr(0, one.find('=') + 1);
        if (std::ranges::none_of(more, [&](const std::string& other) { return other.starts_with(name); }))
            variables.push_back(*own);
    }
    variables.push_back(nullptr);
    auto [failure, failure_end] =
        connected_pair();  // closed by a successful exec; otherwise carries its error
    // Between fork and exec the child neither allocates nor locks.
    ChildProcess child("start " + words.at(0), [&, end = failure_end.get()] {
        for (int i = 0; i < 3; ++i) dup2(streams[static_cast<std::size_t>(i)], i);
        if (limits != nullptr) limit_this_process(*limits);
        if (limits != nullptr && limits->group) setpgid(0, 0);
        environ = variables.data();
        execvp(arguments[0], arguments.data());
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

bool send_all(int connection, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
        if (count < 0 && errno != EINTR) return false;
    }
    return true;
}

Arrival receive_some(int connection, Clock::time_point deadline, std::size_t most, std::string& text) {
    while (true) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
        pollfd one{.fd = connection, .events = POLLIN, .revents = 0};
        const int ready = poll(&one, 1, static_cast<int>(std::clamp<long long>(left, 0, 1'000'000)));
        if (ready == 0 && Clock::now() >= deadline) return Arrival::silence;
        if (ready <= 0) continue;  // interrupted
        std::array<char, 65536> block{};
        const ssize_t count = recv(connection, block.data(), std::min(block.size(), most), 0);
        if (count == 0 || (count < 0 && errno != EINTR)) return Arrival::end;
        if (count < 0) continue;
        text.append(block.data(), static_cast<std::size_t>(count));
        return Arrival::bytes;
    }
}

void limit_this_process(const ProcessLimits& limits) {
    limit(RLIMIT_CORE, 0);
    if (limits.memory_bytes != 0 && address_space_is_ours) limit(RLIMIT_AS, limits.memory_bytes);
    if (limits.cpu.count() != 0) limit(RLIMIT_CPU, static_cast<rlim_t>(limits.cpu.count()), 1);
}

}  // namespace gloam::base::internal
