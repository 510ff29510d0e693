// SPDX-License-Identifier: MIT
#include "base/internal/child_process.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <thread>
#include <utility>

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
    if (id_ <= 0 || !is_ours()) return;
    kill();
    (void)wait();
}

bool ChildProcess::is_ours() const {
    return parent_ == getpid();
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

bool ChildProcess::has_ended_by(std::chrono::steady_clock::time_point deadline) const {
    siginfo_t info{};
    do {
        info.si_pid = 0;
        if (waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) != 0) return true;
        if (info.si_pid != 0) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    } while (std::chrono::steady_clock::now() < deadline);
    return false;
}

void limit_this_process(const ProcessLimits& limits) {
    limit(RLIMIT_CORE, 0);
    if (limits.memory_bytes != 0 && address_space_is_ours) limit(RLIMIT_AS, limits.memory_bytes);
    if (limits.cpu.count() != 0) limit(RLIMIT_CPU, static_cast<rlim_t>(limits.cpu.count()), 1);
}

}  // namespace gloam::base::internal
