// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam bench temporal`.
struct BenchTemporalOptions {
    std::vector<std::string> scenes{"moving", "columns"};
    std::string preset = "paper";
    std::string size = "192x108";
    int frames = 48;        // of the moving scene
    int still_frames = 32;  // of its first view alone
    int every = 4;          // every how many frames one is scored
    int rays = 256;         // of the truth, for each pixel
    bool quick = false;
    std::string device;
    bool validation = false;
    std::filesystem::path json;  // empty: not written
    std::filesystem::path out;   // empty: no pictures
};

// Measures the temporal effect on moving and still scenes, and prints the results. Returns the exit status:
// 0, or 1 if the validation layers reported messages.
[[nodiscard]] int run_bench_temporal(BenchTemporalOptions options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_temporal(CLI::App& bench, int& status);

}  // namespace gloam::cli
