// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.hpp"
#include "record/check_report.hpp"

namespace gloam::cli {

// With this option the program ends with status 125 instead of 2.
constexpr std::string_view bisect_option = "--exit-code";

// The options of `gloam check`.
struct CheckOptions {
    EquationsNamed* named = nullptr;
    std::vector<std::string>
        equations;                      // IDs, functions or globs; empty: all. Or a shader file and functions
    std::vector<std::string> ranges;    // of a shader file's parameters: "x=0:1"
    std::vector<std::string> includes;  // further include roots of a shader file
    std::vector<std::string> defines;   // macros of a shader file
    std::string device;                 // name, index or "all"; empty: the default
    std::string variant = "shipped";    // see variants(), or "all"
    std::vector<std::string> compilers;  // steps after it (module/steps.hpp), joined by " | "; each a variant
    std::size_t inputs = 65'536;
    std::uint64_t seed = 1;
    std::string shard;  // see shard_from()
    bool coverage = false;
    bool validation = false;
    double timeout = 120.0;  // seconds for each check
    std::size_t jobs = 0;    // worker processes for each device; 0: chosen by the amount of work
    bool in_process = false;
    std::filesystem::path json;
    bool resume = false;  // continue from the journal beside `json`
    std::filesystem::path junit;
    std::filesystem::path failures;  // folder for failures, prepared for a report
    std::filesystem::path html;      // page of the results; empty: none
    bool rows = true;                // print the device and a line for each check
    bool progress = true;            // on a terminal
};

// The results of every device.
struct CheckOutcome {
    std::vector<record::CheckReport> reports;
    record::OutcomeCounts counts;
    std::vector<std::string> notes;  // on a user's file, a line each: what was left out, and why
    bool complete = true;            // no function was left out that was named or that does not compile
};

// Runs the checks and writes the requested files.
[[nodiscard]] CheckOutcome check(const CheckOptions& options);

}  // namespace gloam::cli
