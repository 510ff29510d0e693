// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// What `gloam bench methods` was asked.
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
    std::filesystem::path page;  // empty: no page gets new tables
};

// Compares all methods on views in closed form and on scenes, and prints the tables. Returns the exit status:
// 0, or 1 when the validation layers had something to say.
[[nodiscard]] int run_bench_methods(const BenchMethodsOptions& options);

// Adds the subcommand; `status` receives what it returns.
void add_bench_methods(CLI::App& bench, int& status);

}  // namespace gloam::cli
