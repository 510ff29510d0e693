// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam bench views`.
struct BenchViewsOptions {
    std::vector<std::string> views;     // empty: all
    std::string half;                   // "tuning" or "unseen": only these; empty: both
    std::vector<std::string> single;    // presets or files of presets, each frame alone
    std::vector<std::string> sequence;  // the same, in sequence with their history
    std::vector<std::string> set;       // NAME=VALUE, for all of them; lengths for a radius of 1
    std::string size = "160x90";
    int frames = 16;
    int scored = 8;
    int rounds = 1;  // 0: nothing is timed
    int rays = 128;
    std::optional<double> depth_thickness;  // of the surface of (D), in radii; without it solid
    bool no_depth_truth = false;            // (D) is not traced: half the time of a first run
    std::filesystem::path meshes;  // folder of the mesh files; empty: where the package installs them
    std::string device;
    bool validation = false;
    std::filesystem::path json;  // empty: not written
    std::filesystem::path page;  // page that gets the tables; empty: none
};

// Measures presets on the views of scene/views.hpp and prints a row for each view, and the means of both
// halves. Returns the exit status: 0; 1 if the validation layers reported messages.
[[nodiscard]] int run_bench_views(const BenchViewsOptions& options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_views(CLI::App& bench, int& status);

}  // namespace gloam::cli
