// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gloam::cli {

// The options of `gloam report --summary`.
struct SummaryOptions {
    std::vector<std::string> paths;  // files, and folders of which all *.json files count
    std::filesystem::path since;     // JSON lines of an earlier summary; empty: none
    std::filesystem::path lines;     // file for the JSON lines; empty: none
    std::filesystem::path html;      // file for the page; empty: none
};

// Summarises the results of many machines and prints them. Files that are no results are named on standard
// error, and the others count. Returns the exit status: 0; 1 if a check failed or a file is no result. Throws
// std::runtime_error if no file is a result.
[[nodiscard]] int run_summary(const SummaryOptions& options);

}  // namespace gloam::cli
