// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/hidden.hpp"

namespace gloam::base {

// Limits of a program. They also apply to the processes that it starts.
struct ProcessLimits {
    std::uint64_t memory_bytes = 0;  // address space; 0: only this process's own limit
    std::chrono::seconds cpu{0};     // of processor time; 0: no limit
    std::chrono::milliseconds patience{60'000};
    std::size_t output_bytes = std::size_t{1} << 28;  // of standard output, and of standard error
    bool group = false;                      // it leads a group of processes, all of which end with it
    std::vector<std::string> environment{};  // "NAME=value", besides this process's own
};

// How a program ended.
struct ProcessResult {
    enum class End { status, signal, time, output };
    End end = End::status;
    int number = 0;      // the exit status, or the signal
    std::string output;  // of standard output
    std::string errors;  // end of standard error, without trailing white space

    [[nodiscard]] bool succeeded() const { return end == End::status && number == 0; }
    // "ended with status 3: its last words", "ended by signal 11 (SEGV: Segmentation fault)", "did not end
    // within 60 s".
    [[nodiscard]] std::string how() const;
};

// "ended by signal 11 (SEGV: Segmentation fault)" or "ended with status 3", from a status of waitpid().
[[nodiscard]] std::string how_it_ended(int wait_status);

// Runs a program to its end, without a shell and without input. command[0]: a path, or a name to find in
// PATH. The program never outlives this call. Throws std::system_error if it cannot be started.
[[nodiscard]] ProcessResult run_process(const std::vector<std::string>& command, const ProcessLimits& limits);

// A program that answers lines with lines. Its standard input and output are connected to this process; its
// standard error goes to an unnamed file. It is killed with the object, and when the thread that started it
// ends (and so when this process ends for any reason).
class WorkerProcess {
  public:
    using Clock = std::chrono::steady_clock;
    enum class Heard { line, end, silence };

    // command[0]: a path, or a name to find in PATH. Throws std::system_error when it cannot be started.
    explicit WorkerProcess(const std::vector<std::string>& command);

    // Sends a line. Returns false if the program cannot receive it.
    bool send(std::string_view line);

    // Waits for a complete line (returned without its end), for the end of the output, or until the deadline.
    [[nodiscard]] Heard receive(std::string& line, Clock::time_point deadline);

    // Ends the program if it still runs. Returns how it ended: "ended by signal 11 (SEGV: Segmentation
    // fault)", "ended with status 3", with the last text of its standard error.
    [[nodiscard]] std::string end();

    [[nodiscard]] pid_t id() const;

  private:
    struct Running;
    Hidden<Running> running_;
    std::string heard_;  // received but not yet returned
};

// Processor time that a process has used, over all its threads; zero for a process that has ended.
[[nodiscard]] std::chrono::nanoseconds processor_time_of(pid_t process);

// Waits for what a process does: calls done(until), which waits until then at the longest, until it returns
// true. A process that shares the machine can need far longer than alone, but a process that waits for an
// event that never comes uses no processor time. So a wait ends after its limit, which is positive, if the
// process has used that much processor time itself, or next to none since the last look. `used`: the
// processor time that it has used so far.
void wait_patiently(std::chrono::nanoseconds limit, const std::function<std::chrono::nanoseconds()>& used,
                    const std::function<bool(std::chrono::steady_clock::time_point until)>& done);

// An exception of the work itself; what() is its message.
class WorkError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The work did not complete: "takes more than 60 s", "takes more than 4096 MiB of memory", "ended by signal
// 11 (SEGV: Segmentation fault)".
class LimitError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Calls `work` in a forked copy of this process and returns its result. Memory, time and crashes of the copy
// do not affect this process. limits.memory_bytes is added to what this process already uses. Throws
// WorkError, LimitError, and std::system_error if no process can be created.
[[nodiscard]] std::string run_apart(const std::function<std::string()>& work, const ProcessLimits& limits);

// Of compilers of texts from elsewhere: far beyond the needs of any reasonable shader.
inline const ProcessLimits compiler_limits{.memory_bytes = std::uint64_t{3} << 30,
                                           .cpu = std::chrono::seconds(60),
                                           .patience = std::chrono::minutes(5)};

// What a compiler makes of a text in a copy of this process. Throws WorkError, and LimitError, "NAME: the
// compiler takes more than 60 s", if the copy does not survive it.
std::string try_compiler(const std::filesystem::path& name, const std::function<std::string()>& work);

// The result of the work, which is tried first. A text is the copy's.
template <class Work>
auto tried(const std::filesystem::path& name, const Work& work) {
    if constexpr (std::is_same_v<decltype(work()), std::string>) return try_compiler(name, work);
    try {
        (void)try_compiler(name, [&work] { return (void)work(), std::string(); });
    } catch (const WorkError&) {  // the work will say so itself
    }
    return work();
}

}  // namespace gloam::base
