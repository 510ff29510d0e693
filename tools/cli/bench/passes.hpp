// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam bench passes`.
struct BenchPassesOptions {
    std::string size = "1280x720";
    int rounds = 5;                 // over all cases
    std::string inputs = "device";  // "device", "sampled" or "storage": scene::Inputs
    std::string device;
    bool validation = false;
    std::filesystem::path json;  // empty: not written
};

// Times every pass of a frame, in copies, and prints the table. Returns the exit status: 0, or 1 if the
// validation layers reported messages.
[[nodiscard]] int run_bench_passes(const BenchPassesOptions& options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_passes(CLI::App& bench, int& status);

}  // namespace gloam::cli
