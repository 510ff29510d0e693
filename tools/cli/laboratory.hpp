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
    std::filesystem::path lines;     // where to write JSON lines; empty: nowhere
    std::filesystem::path html;      // the same of the page
};

// Summarises the results of many machines and prints them. Files that are no results are named on standard
// error, and the others count. Returns the exit status: 0; 1 if a check failed or a file is no result. Throws
// std::runtime_error if no file is a result.
[[nodiscard]] int run_summary(const SummaryOptions& options);

}  // namespace gloam::cli
