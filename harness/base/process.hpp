// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::base {

// Limits of a program. They also apply to the processes that it starts.
struct ProcessLimits {
    std::uint64_t memory_bytes = 0;  // address space; 0: only this process's own limit
    std::chrono::seconds cpu{0};     // of processor time; 0: no limit
    std::chrono::milliseconds patience{60'000};
    std::size_t output_bytes = std::size_t{1} << 28;
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

// Runs a program to its end, without a shell. `input`: for its standard input. command[0]: a path, or a name
// to find in PATH. The program never outlives this call. Throws std::system_error if it cannot be started.
[[nodiscard]] ProcessResult run_process(const std::vector<std::string>& command, std::string_view input,
                                        const ProcessLimits& limits);

}  // namespace gloam::base
