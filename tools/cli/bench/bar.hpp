// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam bench bar`.
struct BenchBarOptions {
    std::vector<std::string> scenes;  // empty: all built-in ones whose camera moves
    std::string preset = "fast";      // of the temporal run
    std::string method;               // empty: the preset's
    std::optional<std::uint32_t> samples;
    std::vector<std::string> set;  // NAME=VALUE
    std::string exact = "9x3";     // SLICESxSTEPS of the single frame that bounds the error
    std::string fast = "1x2";      // SLICESxSTEPS of the single frame that bounds the time
    std::string size = "192x108";
    int frames = 16;  // half of them, at most 8, are scored
    int rounds = 5;
    int rays = 256;  // of the truth, for each pixel
    bool fail_if_missed = false;
    std::string device;
    bool validation = false;
    std::filesystem::path json;  // empty: not written
    std::filesystem::path page;  // page that gets the table; empty: none
};

// Compares a temporal run with single frames of a plain loop over slices: its error must not exceed that of
// one, its time not that of another. Prints a row for each scene. Returns the exit status: 0; 1 if the
// validation layers reported messages, or if a scene misses the bar and --fail-if-missed is given.
[[nodiscard]] int run_bench_bar(const BenchBarOptions& options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_bar(CLI::App& bench, int& status);

}  // namespace gloam::cli
