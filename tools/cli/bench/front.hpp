// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam bench front`.
struct BenchFrontOptions {
    std::vector<std::string> views;  // empty: all of the half
    std::string half = "unseen";
    std::vector<std::string> plain{"9x3+0", "1x2+1", "3x3+2"};  // SLICESxSTEPS+BLURS
    std::vector<std::string> single{"sweep-quality"};           // PRESET[,NAME=VALUE...]
    std::vector<std::string> sequence{"fast",           "balanced",  "sweep-half", "sweep-performance",
                                      "sweep-balanced", "reference", "moving"};
    std::vector<std::string> sizes{"640x360", "1280x720"};
    int frames = 16;
    int scored = 1;
    int rounds = 1;
    int rays = 64;
    std::filesystem::path meshes;  // empty: where the package installs them
    std::string device;
    bool validation = false;
    std::filesystem::path json;  // empty: not written
    std::filesystem::path page;  // page that gets the tables; empty: none
};

// Measures error and time of presets, in sequence and alone, beside single frames of a plain loop over
// slices, on the perspective views of a half, at several sizes. Returns the exit status: 0; 1 if the
// validation layers reported messages.
[[nodiscard]] int run_bench_front(const BenchFrontOptions& options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_front(CLI::App& bench, int& status);

}  // namespace gloam::cli
