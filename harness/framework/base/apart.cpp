// SPDX-License-Identifier: MIT
#include "base/process.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <utility>

#include "base/files.hpp"
#include "base/internal/child_process.hpp"

namespace gloam::base {
namespace {

using internal::Clock;

// The first byte of the copy's answer.
constexpr char returned = 'r';
constexpr char thrown = 't';
constexpr char out_of_memory = 'm';

// Bytes of address space of this process.
std::uint64_t own_memory() {
    unsigned long pages = 0;
    std::FILE* file = std::fopen("/proc/self/statm", "re");
    if (file == nullptr) return 0;
    const int read = std::fscanf(file, "%lu", &pages);
    std::fclose(file);
    return read == 1 ? std::uint64_t{pages} * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

// The result or the failure of the work, in one text.
std::string answer_of(const std::function<std::string()>& work) {
    try {
        return returned + work();
    } catch (const std::bad_alloc&) {
        return std::string(1, out_of_memory);
    } catch (const std::exception& error) {
        return thrown + std::string(error.what());
    }
}

// Sets the limit on processor time to this much from now; it can be set again.
void limit_time(std::chrono::seconds more) {
    rusage used{};
    rlimit limit{};
    if (more.count() == 0 || getrusage(RUSAGE_SELF, &used) != 0 || getrlimit(RLIMIT_CPU, &limit) != 0) return;
    const auto spent = static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1);
    limit.rlim_cur = std::min(limit.rlim_max, spent + static_cast<rlim_t>(more.count()));
    setrlimit(RLIMIT_CPU, &limit);
}

// Receives exactly this many bytes; false if the connection ends or the deadline passes first.
bool receive(int connection, Clock::time_point deadline, std::size_t bytes, std::string& text) {
    text.clear();
    while (text.size() < bytes) {
        const auto arrived = internal::receive_some(connection, deadline, bytes - text.size(), text);
        if (arrived != internal::Arrival::bytes) return false;
    }
    return true;
}

// A message is its length and its bytes.
bool receive_message(int connection, Clock::time_point deadline, std::string& text) {
    std::uint64_t length = 0;
    if (!receive(connection, deadline, sizeof length, text)) return false;
    std::memcpy(&length, text.data(), sizeof length);
    return receive(connection, deadline, length, text);
}

bool send_message(int connection, std::string_view text) {
    const std::uint64_t length = text.size();
    std::string whole(reinterpret_cast<const char*>(&length), sizeof length);
    whole += text;
    return internal::send_all(connection, whole);
}

[[noreturn]] void answer_questions(const Apart::Work& work, const ProcessLimits& limits, int connection) {
    internal::limit_this_process({.memory_bytes = limits.memory_bytes});
    for (std::string question; receive_message(connection, Clock::time_point::max(), question);) {
        limit_time(limits.cpu);
        const std::string answer = answer_of([&] { return work(question); });
        if (!send_message(connection, answer) || answer.front() == out_of_memory) break;
    }
    _exit(0);
}

}  // namespace

struct Apart::Copy {
    explicit Copy(const Apart& apart) : Copy(apart, connected_pair()) {}

    FileDescriptor connection;
    internal::ChildProcess child;

  private:
    Copy(const Apart& apart, std::pair<FileDescriptor, FileDescriptor> ends)
        : connection(std::move(ends.first)),
          child("start a process", [&apart, &ends, ours = connection.get()] {
              close(ours);
              ProcessLimits limits = apart.limits_;
              if (limits.memory_bytes != 0) limits.memory_bytes += own_memory();
              answer_questions(apart.work_, limits, ends.second.get());
          }) {}
};

Apart::Apart(Work work, const ProcessLimits& limits) : work_(std::move(work)), limits_(limits) {}

Apart::~Apart() = default;

std::string Apart::ask(std::string_view question) {
    // After a fork, two processes would mix their questions on one connection.
    if (copy_ && !copy_->child.is_ours()) copy_.reset();
    if (!copy_) copy_ = std::make_unique<Copy>(*this);
    std::string answer;
    const auto deadline = Clock::now() + limits_.patience;
    const bool heard = send_message(copy_->connection.get(), question) &&
                       receive_message(copy_->connection.get(), deadline, answer);
    const std::string too_long = fmt::format("takes more than {} s", limits_.cpu.count());
    if (!heard || answer.empty()) {
        const std::unique_ptr<Copy> failed = std::move(copy_);
        if (Clock::now() >= deadline) throw LimitError(too_long);
        const int status = failed->child.wait();
        throw LimitError(WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU ? too_long
                                                                            : how_it_ended(status));
    }
    const char kind = answer.front();
    answer.erase(0, 1);
    if (kind == returned) return answer;
    if (kind == thrown) throw WorkError(answer);
    copy_.reset();
    throw LimitError(fmt::format("takes more than {} MiB of memory", limits_.memory_bytes >> 20));
}

std::string run_apart(const std::function<std::string()>& work, const ProcessLimits& limits) {
    return Apart([&work](std::string_view) { return work(); }, limits).ask("");
}

}  // namespace gloam::base
