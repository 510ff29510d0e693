// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam bench plain`.
struct BenchPlainOptions {
    std::vector<std::string> methods{"gtao"};            // of slices
    std::vector<std::string> taps{"1x2", "3x3", "9x3"};  // SLICESxSTEPS
    std::string scene = "columns";
    std::string size = "640x360";
    int rounds = 15;
    std::string device;
    bool validation = false;
    std::filesystem::path json;  // empty: not written
    std::filesystem::path page;  // page that gets the table; empty: none
};

// Times the sampling pass of methods, single frames without history, and that of a plain loop with equal taps
// in turn. Prints a row for each. Returns the exit status: 0, or 1 if the validation layers reported
// messages.
[[nodiscard]] int run_bench_plain(const BenchPlainOptions& options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_plain(CLI::App& bench, int& status);

}  // namespace gloam::cli
