// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::base {

// What a program may take. What it starts itself is bound by the same.
struct ProcessLimits {
    std::uint64_t memory_bytes = 0;  // address space; 0: no limit but this process's own
    std::chrono::seconds cpu{0};     // of processor time; 0: none
    std::chrono::milliseconds patience{60'000};
    std::size_t output_bytes = std::size_t{1} << 28;
};

// What became of a program.
struct ProcessResult {
    enum class End { status, signal, time, output };
    End end = End::status;
    int number = 0;      // the exit status, or the signal
    std::string output;  // of standard output
    std::string errors;  // the last of standard error, without white space at its end

    [[nodiscard]] bool succeeded() const { return end == End::status && number == 0; }
    // "ended with status 3: its last words", "ended by signal 11 (SEGV: Segmentation fault)", "did not end
    // within 60 s".
    [[nodiscard]] std::string how() const;
};

// "ended by signal 11 (SEGV: Segmentation fault)" or "ended with status 3", from what waitpid() gives.
[[nodiscard]] std::string how_it_ended(int wait_status);

// Runs a program to its end, no shell between: `input` on its standard input, command[0] a path or a name
// that PATH finds. It never outlives this call. Throws std::system_error when it cannot be started.
[[nodiscard]] ProcessResult run_process(const std::vector<std::string>& command, std::string_view input,
                                        const ProcessLimits& limits);

}  // namespace gloam::base
