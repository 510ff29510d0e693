// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "cli/commands.hpp"
#include "cli/framework/own_file.hpp"
#include "judge/run.hpp"
#include "record/check_report.hpp"

namespace gloam::cli {

// With this option the program ends with status 125 instead of 2.
constexpr std::string_view bisect_option = "--exit-code";

// One check.
struct CheckTask {
    judge::AnswerIdentity identity;  // of the row, until that says more
    judge::RunOptions run;
    bool coverage = false;
    std::string path;  // of a user's file; empty: an equation of the catalogue
    OwnFileOptions own;
};

// The options of `gloam check`.
struct CheckOptions {
    EquationsNamed* named = nullptr;
    std::vector<std::string>
        equations;                    // IDs, functions or globs; empty: all. Or a shader file and functions
    CheckTask task;                   // what all checks have
    std::string device;               // name, index or "all"; empty: the default
    std::string manifest;             // of the only driver, on which the device is; empty: of any
    std::string variant = "shipped";  // see variants(), or "all"
    std::vector<std::string> compilers;  // steps after it (module/steps.hpp), joined by " | "; each a variant
    std::string shard;                   // "INDEX/COUNT"; empty: of GoogleTest's variables
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

    // The longest wait for a worker, and for one submission to a device.
    [[nodiscard]] std::chrono::milliseconds patience() const {
        return std::chrono::milliseconds(std::max(1L, std::lround(timeout * 1000.0)));
    }

    // Of the rows while the check runs, from which --resume continues a killed run; empty without `json`.
    [[nodiscard]] std::filesystem::path journal() const {
        return json.empty() ? "" : json.string() + ".journal";
    }
};

// The results of every device.
struct CheckOutcome {
    std::vector<record::CheckReport> reports;
    record::OutcomeCounts counts;
    std::vector<std::string> notes;  // on a user's file, a line each: what was left out, and why
    // There are checks, and no function was left out that was named or that does not compile.
    bool complete = true;
    std::string shard;  // "0/3"; empty: all checks
};

// Runs the checks and writes the requested files.
[[nodiscard]] CheckOutcome check(const CheckOptions& options);

}  // namespace gloam::cli
