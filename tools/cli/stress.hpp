// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gloam::cli {

// The options of `gloam stress`.
struct StressOptions {
    std::string only;
    std::vector<std::string> equations;  // name of one run; empty: all
    std::string device;                  // name or index; empty: the default
    std::uint64_t seed = 1;
    std::uint64_t frames = 1'000'000;
    bool brief = false;
    bool validation = false;
    std::filesystem::path json;
};

// Runs the searches and prints a line for each number. Returns the exit status: 1 if a bound is broken,
// otherwise 0.
[[nodiscard]] int run_stress(const StressOptions& options);

// Adds the subcommand; `status` receives what it returns.
void add_stress(CLI::App& app, int& status);

}  // namespace gloam::cli
