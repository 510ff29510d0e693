// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gloam::cli {

// What `gloam check` was asked.
struct CheckOptions {
    std::vector<std::string>
        equations;                    // IDs, functions or globs; empty: all. Or a shader file and functions
    std::vector<std::string> ranges;  // of a shader file's parameters: "x=0:1"
    std::string device;               // name, index or "all"; empty: the default
    std::string variant = "shipped";  // see variants(), or "all"
    std::size_t inputs = 65'536;
    std::uint64_t seed = 1;
    std::string shard;  // see shard_from()
    bool validation = false;
    double timeout = 120.0;  // seconds for each check
    std::size_t jobs = 1;    // worker processes
    bool in_process = false;
    std::filesystem::path json;
    std::filesystem::path junit;
    std::filesystem::path failures;  // folder for what failed, ready to report
};

// Runs the checks, prints a line for each and the story of each failure. Returns the exit status: 0 or 1.
[[nodiscard]] int run_check(const CheckOptions& options);

// Adds the subcommand; `status` receives what it returns.
void add_check(CLI::App& app, int& status);

}  // namespace gloam::cli
