// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <new>

#include "base/files.hpp"
#include "base/internal/child_process.hpp"
#include "base/process.hpp"

namespace gloam::base {
namespace {

using internal::Clock;

// The first byte of the copy's answer. Without an answer, it did not end by itself.
constexpr char returned = 'r';
constexpr char thrown = 't';
constexpr char out_of_memory = 'm';

// Bytes of address space of this process.
std::uint64_t own_memory() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
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

// All that the other end sends until it ends; empty if the deadline passes first.
std::string all_from(int connection, Clock::time_point deadline) {
    constexpr std::size_t block = 65536;
    std::string text;
    while (true) {
        const auto arrived = internal::receive_some(connection, deadline, block, text);
        if (arrived == internal::Arrival::silence) return "";
        if (arrived == internal::Arrival::end) return text;
    }
}

}  // namespace

std::string run_apart(const std::function<std::string()>& work, const ProcessLimits& limits) {
    auto [ours, theirs] = connected_pair();
    internal::ChildProcess child("start a process", [&, connection = ours.get(), other = theirs.get()] {
        close(connection);
        ProcessLimits further = limits;
        if (further.memory_bytes != 0) further.memory_bytes += own_memory();
        internal::limit_this_process(further);
        (void)internal::send_all(other, answer_of(work));
        shutdown(other, SHUT_WR);  // a copy that another thread made may have this end, too
        _exit(0);
    });
    theirs.reset();
    const auto deadline = Clock::now() + limits.patience;
    std::string answer = all_from(ours.get(), deadline);
    const std::string too_long = fmt::format("takes more than {} s", limits.cpu.count());
    if (answer.empty() && Clock::now() >= deadline) throw LimitError(too_long);
    const int status = child.wait();
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) throw LimitError(too_long);
    if (status != 0 || answer.empty()) throw LimitError(how_it_ended(status));
    const char kind = answer.front();
    answer.erase(0, 1);
    if (kind == returned) return answer;
    if (kind == thrown) throw WorkError(answer);
    throw LimitError(fmt::format("takes more than {} MiB of memory", limits.memory_bytes >> 20));
}

std::string try_compiler(const std::filesystem::path& name, const std::function<std::string()>& work) {
    try {
        return run_apart(work, compiler_limits);
    } catch (const LimitError& error) {
        throw LimitError(name.string() + ": the compiler " + error.what());
    }
}

}  // namespace gloam::base
