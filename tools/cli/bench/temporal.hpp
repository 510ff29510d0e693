// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// What `gloam bench temporal` was asked.
struct BenchTemporalOptions {
    std::vector<std::string> scenes{"moving", "columns"};
    std::string preset = "paper";
    std::string size = "192x108";
    int frames = 48;        // of the moving scene
    int still_frames = 32;  // of its first view alone
    int every = 4;          // frames from one that is scored to the next
    int rays = 256;         // of the truth, for each pixel
    bool quick = false;
    std::string device;
    bool validation = false;
    std::filesystem::path json;  // empty: not written
    std::filesystem::path out;   // empty: no pictures
};

// Measures the temporal effect on moving scenes and on still ones, and prints what it found. Returns the exit
// status: 0, or 1 when the validation layers had something to say.
[[nodiscard]] int run_bench_temporal(BenchTemporalOptions options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_temporal(CLI::App& bench, int& status);

}  // namespace gloam::cli
