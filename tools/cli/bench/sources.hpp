// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam bench sources`.
struct BenchSourcesOptions {
    std::string table_scene = "knot";                      // of ISSAO's table 1
    std::vector<std::string> scenes{"columns", "relief"};  // of the study: a hall, and close up
    std::string size = "640x360";
    int rounds = 7;
    int rays = 256;  // of the truth, for each pixel
    std::string device;
    bool validation = false;
    std::filesystem::path json;  // empty: not written
    std::filesystem::path page;  // empty: no page gets new tables
};

// Repeats published experiments and prints the tables. Returns the exit status: 0, or 1 if the validation
// layers reported messages.
[[nodiscard]] int run_bench_sources(const BenchSourcesOptions& options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_sources(CLI::App& bench, int& status);

}  // namespace gloam::cli
