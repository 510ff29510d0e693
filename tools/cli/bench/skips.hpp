// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam bench skips`.
struct BenchSkipsOptions {
    std::string size = "320x180";
    int rounds = 3;  // over all ways to run a case
    std::string device;
    bool validation = false;
    std::filesystem::path json;  // empty: not written
};

// Measures the saving by each skip, and prints the table. Returns the exit status: 0, or 1 if the validation
// layers reported messages.
[[nodiscard]] int run_bench_skips(const BenchSkipsOptions& options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_skips(CLI::App& bench, int& status);

}  // namespace gloam::cli
