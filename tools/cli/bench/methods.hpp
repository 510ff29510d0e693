// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam bench methods`.
struct BenchMethodsOptions {
    std::vector<std::string> scenes{"columns", "corner", "knot"};
    std::vector<std::string> methods;  // empty: all
    std::string size = "192x108";
    int pixels = 257;  // of a side of the views in closed form, odd
    int frames = 8;    // of them, of 1,024 samples
    int rays = 256;    // of the truth, for each pixel
    std::string device;
    bool validation = false;
    std::filesystem::path json;  // empty: not written
    std::filesystem::path out;   // empty: no pictures
    std::filesystem::path page;  // page whose tables are replaced; empty: none
};

// Compares all methods on closed-form views and on scenes, and prints the tables. Returns the exit status: 0,
// or 1 if the validation layers reported messages.
[[nodiscard]] int run_bench_methods(const BenchMethodsOptions& options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_methods(CLI::App& bench, int& status);

}  // namespace gloam::cli
