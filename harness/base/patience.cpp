// SPDX-License-Identifier: MIT
#include "base/patience.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

namespace gloam::base {
namespace {

// A computing process gets at least this share of a core, even on a machine with many of them.
constexpr double least_share = 0.05;
constexpr std::chrono::milliseconds shortest_wait{10};

}  // namespace

std::chrono::nanoseconds processor_time_of(pid_t process) {
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return {};
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

Patience::Patience(std::chrono::nanoseconds limit, Used used)
    : limit_(limit),
      used_(std::move(used)),
      at_begin_(used_()),
      at_look_(at_begin_),
      looked_(Clock::now()),
      next_(looked_ + limit) {}

bool Patience::is_over() {
    const Clock::time_point now = Clock::now();
    if (now < next_) return false;
    const std::chrono::nanoseconds used = used_();
    const std::chrono::duration<double> since_look = used - at_look_;
    const std::chrono::duration<double> waited = now - looked_;
    if (used - at_begin_ >= limit_ || since_look < least_share * waited) return true;
    looked_ = now;
    at_look_ = used;
    next_ = now + std::max<std::chrono::nanoseconds>(limit_ - (used - at_begin_), shortest_wait);
    return false;
}

}  // namespace gloam::base
